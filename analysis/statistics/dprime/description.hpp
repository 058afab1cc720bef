#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic dprime_statistic();

}  // namespace palpate::analysis
