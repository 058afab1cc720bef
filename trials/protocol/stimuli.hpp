#pragma once

#include <memory>
#include <vector>

#include "sim/compliance/cache.hpp"
#include "sim/model/model.hpp"
#include "trials/protocol/protocol.hpp"

namespace palpate::trials {

/// What can be felt in a study: a compiled scene for each of Protocol::stimuli that a trial can present (its
/// condition is presented), null for the others. Compiled once, shared by sittings and threads.
using Stimuli = std::vector<std::shared_ptr<const sim::Model>>;

/// Throws std::invalid_argument as sim::compile() does, with the condition and the cell.
sim::Model compile_stimulus(const Protocol& protocol, const Stimulus& stimulus, sim::ComplianceCache& cache);
Stimuli compile_stimuli(const Protocol& protocol, sim::ComplianceCache& cache);

}  // namespace palpate::trials
