#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

// Lines that results of many statistics share, each with its line end.

/// "Method: exact binomial test (Clopper & Pearson 1934)."
std::string method_line(const Method& method);

/// "p = 0.003 (side greater; greater 0.003, less 0.998, two-sided 0.006)"
std::string p_line(const PValues& p, Side side);

/// Puts the p value of the asked side first: "side" and "p" beside "p_values".
void put_side(nlohmann::ordered_json& json, Side side);

}  // namespace palpate::analysis
