#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic adjust_statistic();

}  // namespace palpate::analysis
