#pragma once

#include <Eigen/Geometry>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// Weights of a triangle's corners whose mean is a place on it; of a triangle without area those of its corners
/// that the place is nearest to are not told apart.
inline Vec3 barycentric(const Vec3& place, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 area = (b - a).cross(c - a);
  const double squared = area.squaredNorm();
  if (squared == 0.0) return Vec3::Constant(1.0 / 3.0);
  const double second = area.dot((place - a).cross(c - a)) / squared;
  const double third = area.dot((b - a).cross(place - a)) / squared;
  return {1.0 - second - third, second, third};
}

}  // namespace palpate::sim
