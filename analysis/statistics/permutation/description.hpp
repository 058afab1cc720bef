#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic permutation_statistic();

}  // namespace palpate::analysis
