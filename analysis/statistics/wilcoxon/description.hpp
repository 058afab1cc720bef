#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic wilcoxon_statistic();

}  // namespace palpate::analysis
