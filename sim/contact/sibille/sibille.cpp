#include "sim/contact/sibille/sibille.hpp"

#include <Eigen/Geometry>

#include "sim/contact/prescribed/prescribed_law.hpp"

namespace palpate::sim {
namespace {

/// Unit normal of a node: the mean of the normals of its polygons, each by its area, where they are now.
Vec3 node_normal(const Body& body, const PlacedBody& placed, int node) {
  Vec3 sum = Vec3::Zero();
  for (int i = body.polygons.incident_begin[node]; i < body.polygons.incident_begin[node + 1]; ++i) {
    const Triangle& corners = body.polygons.triangles[body.polygons.incident[i]];
    const Vec3 a = placed.positions.col(corners[0]);
    sum += (Vec3(placed.positions.col(corners[1])) - a).cross(Vec3(placed.positions.col(corners[2])) - a);
  }
  return sum.normalized();
}

/// Where a node counts as being: of what bodies overlap at rest, each is taken to give way by half.
Vec3 place_of(const CollidingPair& pair, const PrescribedScratch& scratch) {
  return scratch.placement[pair.node_body].positions.col(pair.node) + 0.5 * pair.depth_at_rest * pair.normal;
}

/// Asks the colliding nodes of one pair of bodies to come to their plane.
void ask_plane(const Model& model, int touch_pair, PrescribedScratch& scratch) {
  Vec3 barycentre = Vec3::Zero(), normal = Vec3::Zero();
  int colliding = 0;
  for (const CollidingPair& pair : scratch.pairs) {
    if (pair.touch_pair != touch_pair) continue;
    const PlacedBody& placed = scratch.placement[pair.node_body];
    const double side = pair.node_body == model.pairs[touch_pair].bodies[0] ? 1.0 : -1.0;
    barycentre += place_of(pair, scratch);
    // the bodies face each other
    normal += side * node_normal(model.bodies[pair.node_body], placed, pair.node);
    ++colliding;
  }
  if (colliding == 0 || normal.norm() == 0.0) return;
  barycentre /= colliding;
  normal.normalize();
  for (const CollidingPair& pair : scratch.pairs) {
    if (pair.touch_pair != touch_pair) continue;
    const Vec3 position = place_of(pair, scratch);
    scratch.bodies[pair.node_body].claims.ask(pair.node, -(position - barycentre).dot(normal) * normal,
                                              touch_pair);
  }
}

SolveReport solve_sibille(const Model& model, const FreeState& free, std::span<const double>,
                          LawScratch& scratch, Response& response) {
  auto& own = static_cast<PrescribedScratch&>(scratch);
  if (!find_contacts(model, free, own)) return {};
  for (int pair = 0; pair < std::ssize(model.pairs); ++pair) ask_plane(model, pair, own);
  return apply_claims(model, free, own, response);
}

}  // namespace

constinit const ContactLaw kSibille{
    .name = "sibille",
    .meaning = "they meet halfway, whatever their stiffness (Sibille et al. 2002)",
    .prepare = prepare_where_bodies_touch<PrescribedScratch>,
    .solve = solve_sibille};

}  // namespace palpate::sim
