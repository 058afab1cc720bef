#pragma once

#include <span>

#include "sim/model/effect.hpp"

namespace palpate::sim {

/// Every effect that the design knows, in the order of the slots of a compiled scene.
std::span<const Effect* const> effects();

/// Puts into a model what its scene calls for, effect by effect.
void fill_effects(const Scene& scene, Model& model);

}  // namespace palpate::sim
