#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic glmm_statistic();

}  // namespace palpate::analysis
