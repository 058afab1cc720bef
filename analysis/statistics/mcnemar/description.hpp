#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic mcnemar_statistic();

}  // namespace palpate::analysis
