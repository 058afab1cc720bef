#pragma once

#include "sim/model/free_state.hpp"
#include "sim/model/model.hpp"

namespace palpate::sim {

/// Holds the weighted mean of the probe's nodes: while the probe is in the skin, it is where the probe is,
/// along the probe's axes.
void prescribe_mean(const Probe& probe, const ProbeDisplacement& displacement, ProbeRow& row);

}  // namespace palpate::sim
