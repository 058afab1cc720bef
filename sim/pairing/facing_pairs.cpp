#include "sim/pairing/facing_pairs.hpp"

#include <algorithm>
#include <limits>

#include "sim/pairing/outward.hpp"
#include "sim/surface/aabb_tree.hpp"
#include "sim/surface/barycentric.hpp"

namespace palpate::sim {
namespace {

/// Sets normal and gap, from the surface to the node: along their distance, and where they touch along the surface's
/// normal. @return whether the node stands before the surface
bool set_gap(const Vec3& distance, const Vec3& outward, double rounding, FacingPair& pair) {
  const double length = distance.norm();
  if (length <= rounding) {
    pair.normal = outward.normalized();
    pair.gap = distance.dot(pair.normal);
    return true;
  }
  const bool before = distance.dot(outward) > 0.0;
  pair.gap = before ? length : -length;
  pair.normal = distance / pair.gap;
  return before;
}

}  // namespace

bool touches_at_rest(const Model& model, const FacingPair& pair) {
  return -pair.gap <= model.overlap + rounding_of(model.bodies[pair.polygon_body].tree);
}

NearestPolygon nearest_of(const Body& polygons, const Vec3& place, double within) {
  return find_nearest(polygons.tree, polygons.polygons.triangles, polygons.rest, place, within);
}

Faces face(const Body& polygons, const NearestPolygon& found, const Vec3& place, const Vec3& looks,
           FacingPair& pair) {
  if (found.polygon < 0) return Faces::Nothing;
  const TouchSurface& surface = polygons.polygons;
  const Vec3 outward = outward_at(surface, polygons.rest, found);
  if (outward.isZero(0.0)) return Faces::Nothing;
  const bool before = set_gap(place - found.nearest.point, outward, rounding_of(polygons.tree), pair);
  if (looks.dot(pair.normal) >= 0.0) return Faces::Nothing;
  pair.corners = surface.triangles[found.polygon];
  pair.weights = barycentric(found.nearest.point, polygons.rest.col(pair.corners[0]),
                             polygons.rest.col(pair.corners[1]), polygons.rest.col(pair.corners[2]));
  return before ? Faces::Front : Faces::Back;
}

Faces face_at_rest(const Model& model, FacingPair& pair) {
  const Body &nodes = model.bodies[pair.node_body], &polygons = model.bodies[pair.polygon_body];
  const Vec3 place = nodes.rest.col(pair.node);
  const NearestPolygon found = nearest_of(polygons, place, std::numeric_limits<double>::infinity());
  return face(polygons, found, place, corner_normal(nodes.polygons, nodes.rest, pair.node), pair);
}

namespace {

void add_facing(const Model& model, int touch_pair, int node_body, int polygon_body,
                std::vector<FacingPair>& pairs) {
  const Body& nodes = model.bodies[node_body];
  for (const int node : nodes.colliding_nodes) {
    FacingPair pair{
        .touch_pair = touch_pair, .node_body = node_body, .node = node, .polygon_body = polygon_body};
    // What lies deeper behind a surface than bodies may overlap at rest is not within the body but beyond it, as what
    // lies in the hollow of a tube whose outer wall may be touched.
    const Faces side = face_at_rest(model, pair);
    if (side == Faces::Nothing || (side == Faces::Back && !touches_at_rest(model, pair))) continue;
    pair.gap = std::max(0.0, pair.gap);
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
