#include "sim/pairing/find_pairs.hpp"

#include <algorithm>

#include "sim/pairing/outward.hpp"

namespace palpate::sim {
namespace {

struct Side {
  int body = 0;
  const Body& shape;
  const BodyMotion& motion;
  const PlacedBody& placed;
};

/// Which polygons a node may have passed.
enum class Passed { ThoseItCameTowards, Any };

void find_colliding_nodes(const Side& nodes, const Side& polygons, int touch_pair, Passed passed,
                          Pairs& pairs) {
  const TouchSurface& surface = polygons.shape.polygons;
  const AabbTree& tree = polygons.placed.moved ? polygons.placed.tree : polygons.shape.tree;
  if (tree.nodes.empty()) return;
  if (!nodes.motion.moved && !polygons.motion.moved) return;
  const double rounding = rounding_of(polygons.shape.tree);
  for (const int node : nodes.shape.colliding_nodes) {
    const Vec3 position = nodes.placed.positions.col(node);
    const double moved = nodes.motion.displacement.segment<3>(3 * node).norm() + rounding;
    const Vec3 rest = nodes.shape.rest.col(node);
    const CameFrom from{rest, polygons.shape.rest};
    const NearestPolygon found = find_nearest(tree, surface.triangles, polygons.placed.positions, position,
                                              moved, passed == Passed::ThoseItCameTowards ? &from : nullptr);
    if (found.polygon < 0) continue;
    const Vec3 outward = outward_at(surface, polygons.placed.positions, found);
    if (!((position - found.nearest.point).dot(outward) < 0.0)) continue;
    const Triangle& corners = surface.triangles[found.polygon];
    const Vec3 normal = area_vector(corners, polygons.placed.positions).normalized();
    const double depth = (Vec3(polygons.placed.positions.col(corners[0])) - position).dot(normal);
    if (!(depth > 0.0)) continue;
    pairs.push_back({touch_pair, nodes.body, node, polygons.body, found.polygon, depth, normal});
  }
}

void find_pairs(const Model& model, const FreeMotion& motion, const Placement& placement, Passed passed,
                Pairs& pairs) {
  pairs.clear();
  const auto side = [&](int body) { return Side{body, model.bodies[body], motion[body], placement[body]}; };
  for (int p = 0; p < std::ssize(model.pairs); ++p) {
    const auto [a, b] = model.pairs[p].bodies;
    find_colliding_nodes(side(a), side(b), p, passed, pairs);
    find_colliding_nodes(side(b), side(a), p, passed, pairs);
  }
}

}  // namespace

Placement rest_placement(const Model& model) {
  Placement placement;
  for (const Body& body : model.bodies)
    placement.push_back({.positions = body.rest, .tree = body.tree, .moved = false});
  return placement;
}

void place(const Model& model, const FreeMotion& motion, Placement& placement) {
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const Body& body = model.bodies[i];
    PlacedBody& placed = placement[i];
    const bool was_moved = placed.moved;
    placed.moved = motion[i].moved;
    if (!placed.moved) {  // whatever the cycle before has left
      if (was_moved) placed.positions = body.rest;
      continue;
    }
    const Eigen::Map<const Eigen::Matrix3Xd> displacement(motion[i].displacement.data(), 3, body.rest.cols());
    placed.positions = body.rest + displacement;
    refit(placed.tree, body.polygons.triangles, placed.positions, displacement);
  }
}

std::size_t most_pairs(const Model& model) {
  std::size_t most = 0;
  for (const TouchPair& pair : model.pairs)
    for (const int body : pair.bodies) most += model.bodies[body].colliding_nodes.size();
  return most;
}

void find_pairs(const Model& model, const FreeMotion& motion, const Placement& placement, Pairs& pairs) {
  find_pairs(model, motion, placement, Passed::ThoseItCameTowards, pairs);
}

Vec3 polygon_normal(const Body& body, const PlacedBody& placed, int polygon) {
  return area_vector(body.polygons.triangles[polygon], placed.positions).normalized();
}

std::vector<double> deepest_overlaps(const Model& model, const FreeMotion& motion,
                                     const Placement& placement) {
  Pairs pairs;
  find_pairs(model, motion, placement, Passed::Any, pairs);
  std::vector<double> deepest(model.pairs.size(), 0.0);
  for (const CollidingPair& pair : pairs) {
    double& depth = deepest[pair.touch_pair];
    depth = std::max(depth, pair.depth);
  }
  return deepest;
}

}  // namespace palpate::sim
