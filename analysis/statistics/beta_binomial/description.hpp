#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic beta_binomial_statistic();

}  // namespace palpate::analysis
