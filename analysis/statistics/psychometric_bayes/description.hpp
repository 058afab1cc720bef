#pragma once

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

Statistic psychometric_bayes_statistic();

}  // namespace palpate::analysis
