#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic same_different_statistic();

}  // namespace palpate::analysis
