#pragma once

#include "sim/model/probe_kind.hpp"

namespace palpate::sim {

/// A finger pad of a radius: the surface nodes within it that hang together with the middle through such
/// nodes, weighted by their share of surface area times 1 - (distance / radius)^2. With a reach it slides over the surface
/// that faces it (sim/probe/slide): its footprint between three nodes is the mean of those at the nodes.
extern const ProbeKind kPad;

}  // namespace palpate::sim
