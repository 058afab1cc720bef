#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic examinee_level_statistic();

}  // namespace palpate::analysis
