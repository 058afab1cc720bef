#pragma once

#include "sim/model/effect.hpp"

namespace palpate::sim {

/// A body that is softer than its material says, by the share `bodies.NAME.softening`.
extern const Effect kSoftening;

}  // namespace palpate::sim
