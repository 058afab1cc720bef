#pragma once

#include <vector>

#include "sim/compliance/cache.hpp"
#include "sim/model/model.hpp"
#include "sim/scene/scene.hpp"

namespace palpate::sim {

struct CompiledBody {
  Body body{};
  std::vector<Probe> probes{};  // that press it, in the order of the specs, without the body's number
};

/// Reads, places and condenses a body, and puts its probes on it.
CompiledBody compile_body(const BodySpec& spec, const std::vector<const ProbeSpec*>& probes,
                          ComplianceCache& cache);

}  // namespace palpate::sim
