#include "analysis/statistics/psychometric/merge_bootstrap.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "analysis/numerics/infinity.hpp"
#include "base/text/counted.hpp"

namespace palpate::analysis {
namespace {

using nlohmann::ordered_json;

double value_or(const ordered_json& json, double otherwise) {
  return json.is_null() ? otherwise : json.get<double>();
}

std::vector<Replicate> replicates_from(const ordered_json& values) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<Replicate> replicates;
  const std::size_t count = values.at("deviance").size();
  for (std::size_t i = 0; i < count; ++i) {
    replicates.push_back({.alpha = value_or(values.at("alpha").at(i), kNone),
                          .beta = value_or(values.at("beta").at(i), kInfinity),
                          .lapse = value_or(values.at("lapse").at(i), kNone),
                          .deviance = values.at("deviance").at(i)});
  }
  return replicates;
}

const ordered_json& shard_part(const ordered_json& shard) {
  const bool is_shard = shard.is_object() && shard.value("procedure", "") == "psychometric" &&
                        shard.contains("bootstrap") && shard["bootstrap"].is_object() &&
                        shard["bootstrap"].contains("values");
  if (!is_shard) throw std::invalid_argument("not the result of a shard of psychometric");
  return shard["bootstrap"];
}

}  // namespace

void check_bootstrap_part(const ordered_json& shard) {
  const ordered_json& part = shard_part(shard);
  request_from_json(part.at("asked"));
  replicates_from(part.at("values"));
  part.at("shard").get_ref<const std::string&>();
  if (part.at("first").get<long>() > part.at("end").get<long>())
    throw std::invalid_argument("its replicates end before they begin");
}

Outcome merge_bootstrap(const std::vector<ordered_json>& shards) {
  if (shards.empty()) throw std::invalid_argument("no shards to merge");
  std::vector<const ordered_json*> parts;
  parts.reserve(shards.size());
  for (const ordered_json& shard : shards) parts.push_back(&shard_part(shard));
  std::ranges::sort(parts, [](const ordered_json* a, const ordered_json* b) {
    return a->at("first").get<long>() < b->at("first").get<long>();
  });
  const PsychometricRequest request = request_from_json(parts.front()->at("asked"));
  std::vector<Replicate> replicates;
  for (const ordered_json* part : parts) {
    if (part->at("asked") != parts.front()->at("asked"))
      throw std::invalid_argument(fmt::format("shard {} belongs to another request than shard {}",
                                              part->at("shard").get<std::string>(),
                                              parts.front()->at("shard").get<std::string>()));
    const long first = part->at("first"), end = part->at("end");
    const std::vector<Replicate> some = replicates_from(part->at("values"));
    if (first != std::ssize(replicates) || end - first != std::ssize(some)) {
      throw std::invalid_argument(fmt::format("shard {} holds {} from number {} on; expected: number {} next",
                                              part->at("shard").get<std::string>(),
                                              base::counted(std::ssize(some), "replicate", "replicates"),
                                              first + 1, replicates.size() + 1));
    }
    replicates.insert(replicates.end(), some.begin(), some.end());
  }
  if (std::ssize(replicates) != request.replicates) {
    throw std::invalid_argument(
        fmt::format("{} of {} replicates; a shard is missing", replicates.size(), request.replicates));
  }
  return psychometric_outcome(request, replicates);
}

}  // namespace palpate::analysis
