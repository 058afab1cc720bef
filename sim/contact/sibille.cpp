#include <Eigen/Geometry>

#include "sim/contact/laws.hpp"

namespace palpate::sim {
namespace {

/// Unit normal of a node: the mean of the normals of its polygons, each by its area, where they are now.
Vec3 node_normal(const Body& body, const BodyMotion& motion, int node) {
  Vec3 sum = Vec3::Zero();
  const auto at = static_cast<std::size_t>(node);
  for (int i = body.polygons.incident_begin[at]; i < body.polygons.incident_begin[at + 1]; ++i) {
    const Triangle& corners = body.polygons.triangles[body.polygons.incident[i]];
    const Vec3 a = motion.positions.col(corners[0]);
    sum += (Vec3(motion.positions.col(corners[1])) - a).cross(Vec3(motion.positions.col(corners[2])) - a);
  }
  return sum.normalized();
}

}  // namespace

SolveReport sibille(const Model& model, Scratch::Buffers& buffers) {
  for (int p = 0; p < static_cast<int>(model.pairs.size()); ++p) {
    Vec3 barycentre = Vec3::Zero(), normal = Vec3::Zero();
    int colliding = 0;
    for (const CollidingPair& pair : buffers.pairs) {
      if (pair.touch_pair != p) continue;
      const auto body = static_cast<std::size_t>(pair.node_body);
      const BodyMotion& motion = buffers.free_motion[body];
      const double side = pair.node_body == model.pairs[p].bodies[0] ? 1.0 : -1.0;
      barycentre += motion.positions.col(pair.node);
      normal += side * node_normal(model.bodies[body], motion, pair.node);  // the bodies face each other
      ++colliding;
    }
    if (colliding == 0 || normal.norm() == 0.0) continue;
    barycentre /= colliding;
    normal.normalize();
    for (const CollidingPair& pair : buffers.pairs) {
      if (pair.touch_pair != p) continue;
      const auto body = static_cast<std::size_t>(pair.node_body);
      const Vec3 position = buffers.free_motion[body].positions.col(pair.node);
      buffers.bodies[body].actual_claims.ask(pair.node, -(position - barycentre).dot(normal) * normal, p);
    }
  }
  return {};
}

}  // namespace palpate::sim
