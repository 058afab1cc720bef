#pragma once

#include <vector>

#include "sim/cycle/cycle.hpp"
#include "sim/model/model.hpp"
#include "sim/pairing/find_pairs.hpp"

namespace palpate::sim {

/// What the probes prescribe in one cycle: W u = value along the axes of each probe that presses.
struct ProbeRow {
  bool pressing = false;
  Vec3 value = Vec3::Zero();  // [m], one entry an axis: 3 when held, 1 when free
};
using ProbeRows = std::vector<ProbeRow>;  // one a probe

/// A probe presses while its displacement along its direction is positive.
void footprint(const Model& model, Pose pose, ProbeRows& rows);

/// The nodes that a probe holds on a body and their weights (sum 1): for a point the surface node nearest to
/// its place, for a pad the surface nodes within its radius that hang together with that node through such
/// nodes, weighted by their share of surface area times 1 - (distance / radius)^2. Sets nodes and at, nodes
/// still as mesh nodes. Throws std::invalid_argument for an unknown node number and for a node that is fixed.
void place_probe(const ProbeSpec& spec, const TetMesh& mesh, const Surface& surface,
                 const std::vector<int>& fixed, Probe& probe);

}  // namespace palpate::sim
