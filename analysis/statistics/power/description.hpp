#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic power_statistic();

}  // namespace palpate::analysis
