#pragma once

#include "sim/model/model.hpp"

namespace palpate::sim {

/// How deep two bodies reach into each other at rest [m], 0 where they are apart or touch: the largest distance from
/// the boundary of one, inside it, of a node of the other, of the middle of one of its tetrahedra, or of a place on
/// one of its surface's edges (which may cross a body that no node lies in; between two crossings of the boundary 15
/// places are looked at, so that the depth there is found to 1/32 of their distance).
double overlap_at_rest(const Body& a, const Body& b);

/// Throws RefusedKey where two bodies reach into each other at rest by more than is declared, beside what may be
/// rounding (1e-9 of the first body's size). @param declared  the scene's contact.overlap [m]
void refuse_overlap(const Body& a, const Body& b, double declared);

}  // namespace palpate::sim
