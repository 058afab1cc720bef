#pragma once

#include <span>
#include <vector>

#include "sim/model/model.hpp"

namespace palpate::sim {

/// Of the regions that probes hold on a body whose compliance stands: what their motion brings the nodes of the
/// unloaded body, and the forces that it takes.
/// @param probes  of this body, in its order
void finish_regions(const Body& body, std::span<Probe> probes);

}  // namespace palpate::sim
