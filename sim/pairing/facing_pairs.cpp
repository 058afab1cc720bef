#include "sim/pairing/facing_pairs.hpp"

#include <Eigen/Geometry>
#include <limits>

#include "sim/pairing/outward.hpp"
#include "sim/surface/aabb_tree.hpp"

namespace palpate::sim {
namespace {

/// Weights of a triangle's corners whose mean is a place on it; of a triangle without area those of its corners
/// that the place is nearest to are not told apart.
Vec3 barycentric(const Vec3& place, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 area = (b - a).cross(c - a);
  const double squared = area.squaredNorm();
  if (squared == 0.0) return Vec3::Constant(1.0 / 3.0);
  const double second = area.dot((place - a).cross(c - a)) / squared;
  const double third = area.dot((b - a).cross(place - a)) / squared;
  return {1.0 - second - third, second, third};
}

/// From the surface to the node: along their distance, and where they touch along the surface's normal.
/// @return false where the node lies behind the surface. Bodies do not overlap at rest, so it is not within the body
///         but beyond it, as what lies in the hollow of a tube whose outer wall may be touched.
bool set_gap(const Vec3& distance, const Vec3& outward, double rounding, FacingPair& pair) {
  const double length = distance.norm();
  if (length <= rounding) {
    pair.normal = outward.normalized();
    pair.gap = distance.dot(pair.normal);
    return true;
  }
  pair.normal = distance / length;
  pair.gap = length;
  return distance.dot(outward) > 0.0;
}

void add_facing(const Model& model, int touch_pair, int node_body, int polygon_body,
                std::vector<FacingPair>& pairs) {
  const Body &nodes = model.bodies[node_body], &polygons = model.bodies[polygon_body];
  const TouchSurface& surface = polygons.polygons;
  if (polygons.tree.nodes.empty()) return;
  const double rounding = rounding_of(polygons.tree);
  for (const int node : nodes.colliding_nodes) {
    const Vec3 place = nodes.rest.col(node);
    const NearestPolygon found = find_nearest(polygons.tree, surface.triangles, polygons.rest, place,
                                              std::numeric_limits<double>::infinity());
    if (found.polygon < 0) continue;
    const Vec3 outward = outward_at(surface, polygons.rest, found);
    if (outward.isZero(0.0)) continue;
    FacingPair pair{.touch_pair = touch_pair,
                    .node_body = node_body,
                    .node = node,
                    .polygon_body = polygon_body,
                    .corners = surface.triangles[found.polygon]};
    if (!set_gap(place - found.nearest.point, outward, rounding, pair)) continue;
    if (corner_normal(nodes.polygons, nodes.rest, node).dot(pair.normal) >= 0.0) continue;
    pair.weights = barycentric(found.nearest.point, polygons.rest.col(pair.corners[0]),
                               polygons.rest.col(pair.corners[1]), polygons.rest.col(pair.corners[2]));
    pairs.push_back(pair);
  }
}

}  // namespace

std::vector<FacingPair> facing_pairs(const Model& model) {
  std::vector<FacingPair> pairs;
  for (int p = 0; p < std::ssize(model.pairs); ++p) {
    const auto [a, b] = model.pairs[p].bodies;
    if (model.pairs[p].meets[0]) add_facing(model, p, a, b, pairs);
    if (model.pairs[p].meets[1]) add_facing(model, p, b, a, pairs);
  }
  return pairs;
}

}  // namespace palpate::sim
