#pragma once

#include "sim/model/free_state.hpp"
#include "sim/model/model.hpp"

namespace palpate::sim {

/// A probe that slides over the surface: where it is along its direction over the surface at rest is the middle of its
/// footprint, between three knots, and how far it is behind that place is what it presses by. Weights and compliance
/// are those of the knots, each by its share, so all is continuous across nodes and polygons. Beyond the knots it is
/// at their rim. Held, it keeps the mean of its nodes from going sideways; it drags nothing along.
void prescribe_sliding(const Probe& probe, const ProbeDisplacement& displacement, ProbeRow& row);

}  // namespace palpate::sim
