#pragma once

#include "sim/compliance/cache.hpp"
#include "sim/model/model.hpp"
#include "sim/scene/scene.hpp"

namespace palpate::sim {

/// Reads the meshes, condenses (or fetches) the compliances, finds the probes' nodes.
/// Throws std::invalid_argument: a group that the mesh lacks, supports that leave a rigid motion, bodies that
/// overlap at rest, a probe on a fixed node.
Model compile(const Scene& scene, ComplianceCache& cache);

}  // namespace palpate::sim
