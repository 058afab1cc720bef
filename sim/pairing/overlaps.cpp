#include "sim/pairing/overlaps.hpp"

#include <algorithm>
#include <cmath>

#include "sim/pairing/outward.hpp"

namespace palpate::sim {
namespace {

/// A body where its motion has brought it.
struct Placed {
  const Body& body;
  Eigen::Matrix3Xd positions{};
  std::vector<double> motion{};          // of each node [m]
  std::vector<double> polygon_motion{};  // of each polygon [m]
  AabbTree tree{};
};

Placed placed(const Body& body, const BodyMotion& motion) {
  Placed now{.body = body, .positions = body.rest, .motion = std::vector<double>(body.rest.cols(), 0.0)};
  if (motion.moved) {
    const Eigen::Map<const Eigen::Matrix3Xd> by(motion.displacement.data(), 3, body.rest.cols());
    now.positions += by;
    for (Eigen::Index i = 0; i < by.cols(); ++i) now.motion[i] = by.col(i).norm();
  }
  for (const auto& [a, b, c] : body.polygons.triangles)
    now.polygon_motion.push_back(std::max({now.motion[a], now.motion[b], now.motion[c]}));
  now.tree = build_tree(body.polygons.triangles, now.positions);
  return now;
}

/// Deepest place of a node of one body in the other.
double deepest(const Placed& nodes, const Placed& polygons, double declared) {
  const Body& outer = polygons.body;
  if (outer.tree.nodes.empty()) return 0.0;
  const double rounding = rounding_of(outer.tree);
  double depth = 0.0;
  for (const int node : nodes.body.colliding_nodes) {
    const double found =
        depth_inside(outer.polygons, polygons.tree, polygons.positions, nodes.positions.col(node),
                     nodes.motion[node] + declared + rounding, polygons.polygon_motion);
    if (found <= depth) continue;
    const double at_rest =
        depth_inside(outer.polygons, outer.tree, outer.rest, nodes.body.rest.col(node), declared + rounding);
    depth = std::max(depth, found - at_rest);
  }
  return depth;
}

}  // namespace

double depth_inside(const TouchSurface& surface, const AabbTree& tree, const Eigen::Matrix3Xd& positions,
                    const Vec3& place, double within, std::span<const double> moved) {
  const NearestPolygon found = find_nearest(tree, surface.triangles, positions, place, within, moved);
  if (found.polygon < 0) return 0.0;
  const Vec3 outward = outward_at(surface, positions, found);
  return (place - found.nearest.point).dot(outward) < 0.0 ? std::sqrt(found.squared_distance) : 0.0;
}

std::vector<double> deepest_overlaps(const Model& model, const FreeMotion& motion) {
  std::vector<Placed> bodies;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) bodies.push_back(placed(model.bodies[i], motion[i]));
  std::vector<double> all;
  for (const TouchPair& pair : model.pairs) {
    const Placed &a = bodies[pair.bodies[0]], &b = bodies[pair.bodies[1]];
    all.push_back(std::max(deepest(a, b, model.overlap), deepest(b, a, model.overlap)));
  }
  return all;
}

}  // namespace palpate::sim
