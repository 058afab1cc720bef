#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic interval_bias_statistic();

}  // namespace palpate::analysis
