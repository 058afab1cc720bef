#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic yes_no_statistic();

}  // namespace palpate::analysis
