#pragma once

#include "sim/model/probe_kind.hpp"
#include "sim/pairing/facing_pairs.hpp"

namespace palpate::sim {

/// A rigid sphere of a radius that touches the body from outside and only pushes, without friction. Seen along its
/// direction, the nodes below it stay before its front: a height field, so it passes through nothing, however fast it
/// comes, and its force depends on its place alone. It presses no deeper than its radius.
extern const ProbeKind kFingertip;

/// What one of the nodes that a fingertip may meet faces of it, its centre there: normal (away from the sphere) and gap.
/// Of a node outside the sphere these are those of the nearest place on it. One that the sphere has come over at rest is
/// before the sphere's front along the direction, and the gap to there is taken along the sphere's normal there: where
/// a node is on the sphere both are the same. @return false where the node is too far to be touched
bool meet_tip(const Body& body, const Fingertip& tip, const Vec3& direction, const Vec3& centre,
              FacingPair& pair);

}  // namespace palpate::sim
