#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic stevens_statistic();

}  // namespace palpate::analysis
