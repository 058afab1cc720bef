#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic psychometric_compare_statistic();

}  // namespace palpate::analysis
