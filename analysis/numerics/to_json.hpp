#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

// Results as JSON, the same for `palpate stats` and in the report. Numbers are given with all their digits; what is
// infinite or undefined is null. Proportions are fractions, not percent.

nlohmann::ordered_json to_json(double value);                            // null where it is not finite
nlohmann::ordered_json optional_json(const std::optional<long>& value);  // null where there is none
nlohmann::ordered_json to_json(const Interval& interval);
nlohmann::ordered_json to_json(const PValues& p);
nlohmann::ordered_json to_json(const Method& method);

}  // namespace palpate::analysis
