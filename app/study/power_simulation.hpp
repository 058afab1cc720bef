#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/text/shard.hpp"
#include "trials/protocol/protocol.hpp"

namespace palpate::app {

/// Power of a protocol by playing it: whole studies with simulated observers, cycle by cycle.
struct PowerSimulation {
  long studies = 0;  // in all
  std::uint64_t seed = 1;
  std::filesystem::path observer{};
  base::Shard shard{};  // which part of the studies is played here
};

/// "2/4": the second of four. Throws std::invalid_argument.
void read_shard(const std::string& text, PowerSimulation& simulation);

/// Plays the studies of the shard and tests each as the protocol says. The result of a part holds what
/// merging needs; with one part it is the whole. Study k depends on the seed and k alone.
nlohmann::ordered_json simulate_power(const trials::Protocol& protocol, const PowerSimulation& simulation);

/// Throws nlohmann::json::exception or std::invalid_argument unless this has all that merging reads of a
/// part.
void check_power_part(const nlohmann::ordered_json& part);

/// The whole from its parts, in any order, with the same bits as one run gives. Throws std::invalid_argument
/// where parts are missing, overlap, or belong to different simulations.
nlohmann::ordered_json merge_power(const std::vector<nlohmann::ordered_json>& parts);

std::string power_in_words(const nlohmann::ordered_json& result);

}  // namespace palpate::app
