#pragma once

#include <span>

#include "sim/model/effect.hpp"

namespace palpate::sim {

/// Effects that this version does not simulate: off in every scene, their keys refused.
std::span<const Effect* const> later_effects();

}  // namespace palpate::sim
