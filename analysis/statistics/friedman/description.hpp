#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic friedman_statistic();

}  // namespace palpate::analysis
