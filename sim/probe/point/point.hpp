#pragma once

#include "sim/model/probe_kind.hpp"

namespace palpate::sim {

/// The manipulating point of Kuroda et al. 2003: one node.
extern const ProbeKind kPoint;

}  // namespace palpate::sim
