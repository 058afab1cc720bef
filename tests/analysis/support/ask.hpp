#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

/// The arguments of a batch line, "data" and all, as the program reads them.
Outcome run_statistic(const std::string& name, nlohmann::ordered_json asked);

/// What it says when it refuses; fails the test when it does not.
std::string refusal_of(const std::string& name, const nlohmann::ordered_json& asked);

}  // namespace palpate::analysis
