#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/description/statistic.hpp"
#include "analysis/detection/detection.hpp"

namespace palpate::analysis {

// What the statistics on hits and false alarms (yes-no, same-different) share.

Input correction_input(const std::string& usual);

/// The outputs of detection_json, without "criterion".
std::vector<Output> detection_outputs();

/// All but "procedure", "criterion" and "method".
void put_detection(nlohmann::ordered_json& json, const Detection& detection);

/// Rates and d' in words; `yes` is the answer that counts: "yes", "different".
std::string detection_in_words(const Detection& detection, const std::string& signal,
                               const std::string& noise);

}  // namespace palpate::analysis
