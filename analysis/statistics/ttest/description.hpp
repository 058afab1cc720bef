#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic ttest_statistic();

}  // namespace palpate::analysis
