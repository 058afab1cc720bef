#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic critical_statistic();

}  // namespace palpate::analysis
