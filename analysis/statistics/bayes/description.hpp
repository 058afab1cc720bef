#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic bayes_statistic();

}  // namespace palpate::analysis
