#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic similarity_statistic();

}  // namespace palpate::analysis
