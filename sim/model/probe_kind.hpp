#pragma once

#include <span>

#include "sim/mesh/surface.hpp"
#include "sim/mesh/tet_mesh.hpp"
#include "sim/model/exclusion.hpp"
#include "sim/model/free_state.hpp"
#include "sim/model/model.hpp"
#include "sim/scene/accepted.hpp"
#include "sim/scene/scene.hpp"

namespace palpate::sim {

/// A way to press.
struct ProbeKind {
  ProbeKindKeys keys{};                   // its name and the keys that it takes in a scene
  std::span<const Exclusion> excludes{};  // what a scene cannot call for beside it
  bool turns = false;                     // whether it follows the hand's rotation, too

  /// Sets the nodes that the probe holds, as mesh nodes, and their weights (sum 1).
  /// @param middle  the node of the surface that the scene puts the probe at
  void (*hold)(const ProbeSpec& spec, const TetMesh& mesh, const Surface& surface, int middle,
               Probe& probe) = nullptr;

  /// What the probe prescribes where it is now.
  void (*prescribe)(const Probe& probe, const ProbeDisplacement& displacement, ProbeRow& row) = nullptr;
};

}  // namespace palpate::sim
