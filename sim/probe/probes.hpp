#pragma once

#include <vector>

#include "sim/mesh/surface.hpp"
#include "sim/model/free_state.hpp"
#include "sim/model/model.hpp"
#include "sim/scene/scene.hpp"

namespace palpate::sim {

/// Rows with room for all that probes will prescribe.
ProbeRows probe_rows(const Model& model);

/// Whether a probe of the model slides.
bool any_slides(const Model& model);

/// What every probe prescribes where it is now. A displacement below 1e-100 m counts as none.
void prescribe(const Model& model, ProbeDisplacements displacements, ProbeRows& rows);

/// Puts a probe on a body: at the surface node that the scene names, or nearest to the place that it names,
/// and the nodes that the probe's kind holds from there. Sets kind, nodes, weights and at, nodes still as
/// mesh nodes. Throws std::invalid_argument for an unknown node number and for a node that is fixed.
void place_probe(const ProbeSpec& spec, const TetMesh& mesh, const Surface& surface,
                 const std::vector<int>& fixed, Probe& probe);

}  // namespace palpate::sim
