#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "analysis/description/statistic.hpp"
#include "analysis/psychometric/request.hpp"
#include "base/text/shard.hpp"

namespace palpate::analysis {

/// The result of `psychometric` from all replicates. Without replicates (none asked for, or none possible) it
/// says so.
Outcome psychometric_outcome(const PsychometricRequest& request);
Outcome psychometric_outcome(const PsychometricRequest& request, const std::vector<Replicate>& replicates);

/// The result with the replicates of one shard in its "bootstrap" and nothing yet that needs them all.
Outcome psychometric_shard(const PsychometricRequest& request, base::Shard shard);

/// Throws nlohmann::json::exception or std::invalid_argument unless this has all that merging reads of a
/// shard.
void check_bootstrap_part(const nlohmann::ordered_json& shard);

/// The result that one run would have given, to the last bit, from the JSON of all its shards in any order.
/// Throws std::invalid_argument where one is no shard, they belong to different requests, or replicates are
/// missing or there twice.
Outcome merge_bootstrap(const std::vector<nlohmann::ordered_json>& shards);

}  // namespace palpate::analysis
