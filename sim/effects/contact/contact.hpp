#pragma once

#include "sim/model/effect.hpp"

namespace palpate::sim {

/// Bodies act on each other by a contact law.
extern const Effect kContact;

}  // namespace palpate::sim
