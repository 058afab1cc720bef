#pragma once

#include "sim/model/probe_kind.hpp"

namespace palpate::sim {

/// A named group of nodes that is held and moved as one, in six degrees of freedom: a support of its body, which may
/// be the only one.
extern const ProbeKind kRegion;

}  // namespace palpate::sim
