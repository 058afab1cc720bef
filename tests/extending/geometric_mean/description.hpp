#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic geometric_mean_statistic();

}  // namespace palpate::analysis
