#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic looks_statistic();

}  // namespace palpate::analysis
