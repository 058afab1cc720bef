#include "sim/pairing/outward.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace palpate::sim {
namespace {

constexpr double kTouching = 1e-9;  // of a body's size: compile() takes bodies so near for touching

}  // namespace

Vec3 area_vector(const Triangle& corners, const Eigen::Matrix3Xd& positions) {
  const Vec3 a = positions.col(corners[0]);
  return (Vec3(positions.col(corners[1])) - a).cross(Vec3(positions.col(corners[2])) - a);
}

Vec3 corner_normal(const TouchSurface& surface, const Eigen::Matrix3Xd& positions, int node) {
  Vec3 sum = Vec3::Zero();
  for (int i = surface.incident_begin[node]; i < surface.incident_begin[node + 1]; ++i) {
    const Triangle& corners = surface.triangles[surface.incident[i]];
    const auto k = std::ranges::find(corners, node) - corners.begin();
    const Vec3 here = positions.col(node);
    const Vec3 next = Vec3(positions.col(corners[(k + 1) % 3])) - here;
    const Vec3 last = Vec3(positions.col(corners[(k + 2) % 3])) - here;
    const Vec3 area = next.cross(last);
    sum += std::atan2(area.norm(), next.dot(last)) * area.normalized();
  }
  return sum;
}

Vec3 outward_at(const TouchSurface& surface, const Eigen::Matrix3Xd& positions, const NearestPolygon& found) {
  const Triangle& corners = surface.triangles[found.polygon];
  if (found.nearest.corner >= 0) {
    const int node = corners[found.nearest.corner];
    if (surface.rim[node]) return Vec3::Zero();
    return corner_normal(surface, positions, node);
  }
  Vec3 normal = area_vector(corners, positions).normalized();
  if (found.nearest.edge < 0) return normal;
  const int beyond = surface.across[found.polygon][found.nearest.edge];
  if (beyond < 0) return Vec3::Zero();
  return normal + area_vector(surface.triangles[beyond], positions).normalized();
}

double rounding_of(const AabbTree& at_rest) {
  return kTouching * (at_rest.nodes.front().upper - at_rest.nodes.front().lower).norm();
}

}  // namespace palpate::sim
