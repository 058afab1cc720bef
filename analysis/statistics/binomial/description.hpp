#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic binomial_statistic();

}  // namespace palpate::analysis
