#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/statistics/mcnemar/mcnemar.hpp"

namespace palpate::analysis {

/// As `palpate stats` prints it and the report holds it.
nlohmann::ordered_json to_json(const McNemarTest& test);

}  // namespace palpate::analysis
