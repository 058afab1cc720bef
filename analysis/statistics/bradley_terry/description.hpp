#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic bradley_terry_statistic();

}  // namespace palpate::analysis
