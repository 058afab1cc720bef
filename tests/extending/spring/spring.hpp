#pragma once

#include "sim/model/contact_law.hpp"

namespace palpate::sim {

/// Bodies push each other apart like springs: a node that has passed a polygon is pushed back along the
/// polygon's normal by 10 N for each millimetre that it is behind it, and the polygon's corners share the
/// opposite.
extern const ContactLaw kSpring;

}  // namespace palpate::sim
