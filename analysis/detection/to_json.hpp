#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/detection/dprime.hpp"

namespace palpate::analysis {

/// As `palpate stats` prints it and the report holds it.
nlohmann::ordered_json to_json(const DPrime& d_prime);

}  // namespace palpate::analysis
