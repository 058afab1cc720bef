#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic sign_statistic();

}  // namespace palpate::analysis
