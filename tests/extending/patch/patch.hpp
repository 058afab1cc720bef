#pragma once

#include "sim/model/probe_kind.hpp"

namespace palpate::sim {

/// A node of the surface and its neighbours, all alike: their mean follows the probe.
extern const ProbeKind kPatch;

}  // namespace palpate::sim
