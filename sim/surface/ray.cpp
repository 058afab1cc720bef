#include "sim/surface/ray.hpp"

#include <Eigen/Geometry>
#include <limits>

namespace palpate::sim {

double distance_to_triangle(const Vec3& p, const Vec3& along, const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kEdge = 1e-9;  // of a triangle's side: along an edge, no ray slips between two triangles
  const Vec3 ab = b - a, ac = c - a, across = along.cross(ac);
  const double determinant = ab.dot(across);
  if (determinant == 0.0) return kInfinity;
  const Vec3 from_a = p - a;
  const double u = from_a.dot(across) / determinant;
  const Vec3 other = from_a.cross(ab);
  const double v = along.dot(other) / determinant;
  const double distance = ac.dot(other) / determinant;
  if (u < -kEdge || v < -kEdge || u + v > 1 + kEdge || distance <= 0) return kInfinity;
  return distance;
}

}  // namespace palpate::sim
