#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "analysis/description/arguments.hpp"
#include "analysis/psychometric/bootstrap.hpp"
#include "base/text/shard.hpp"

namespace palpate::analysis {

/// All that the result of `psychometric` is computed from.
struct PsychometricRequest {
  std::vector<Block> blocks{};
  PsychometricModel model{};
  std::optional<double> standard{};
  double level = 0.95;
  bool bootstrap_intervals = false;  // else by profile likelihood
  Bootstrap bootstrap = Bootstrap::Parametric;
  long replicates = 0;
  std::uint64_t seed = 1;
};

// From the arguments of a statistic; each throws std::invalid_argument with what was found and is accepted.
std::vector<Block> blocks_of(const DataTable& table);
PsychometricModel model_of(const Arguments& asked);  // shape, guess, lapse, lapse-max, threshold-at
PsychometricRequest psychometric_request(const Arguments& asked);
base::Shard shard_from_text(const std::string& text);

// The same to and from JSON, without loss.
nlohmann::ordered_json to_json(const PsychometricRequest& request);
PsychometricRequest request_from_json(const nlohmann::ordered_json& json);

// Inputs that the statistics of psychometric functions share.
Input shape_input();
Input guess_input();
std::vector<Input> lapse_inputs();
Input threshold_at_input();
Data block_data();

}  // namespace palpate::analysis
