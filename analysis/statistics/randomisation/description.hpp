#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic randomisation_statistic();

}  // namespace palpate::analysis
