#pragma once

#include <array>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// A triangle whose corners go straight from where they rest to where they are, all in the same time.
struct SweptTriangle {
  std::array<Vec3, 3> rest{}, now{};
};

/// How often a place that goes straight from `rest` to `now` in that time goes through the triangle against its
/// normal, less how often along it. The instants are the roots of the cubic that says how far the place is before
/// the triangle's plane [Provot1997]; edges and corners belong to the triangle, with 1e-9 of its size around. A place
/// that rests on the plane, or behind it by rounding, begins before it.
int times_entered(const Vec3& rest, const Vec3& now, const SweptTriangle& triangle);

}  // namespace palpate::sim
