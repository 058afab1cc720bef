#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/statistics/interval_bias/interval_bias.hpp"

namespace palpate::analysis {

/// As `palpate stats` prints it and the report holds it.
nlohmann::ordered_json to_json(const IntervalBias& bias);

}  // namespace palpate::analysis
