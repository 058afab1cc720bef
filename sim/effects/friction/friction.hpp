#pragma once

#include "sim/model/effect.hpp"

namespace palpate::sim {

/// Coulomb friction between bodies that touch: `contact.friction`, with the contact model `exact`.
extern const Effect kFriction;

}  // namespace palpate::sim
