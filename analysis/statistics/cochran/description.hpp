#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic cochran_statistic();

}  // namespace palpate::analysis
