#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/contact/laws.hpp"

// Symbols of the paper: a node a of body A has passed polygon S of body B; F is the foot of the perpendicular
// from a to the plane of S. Here A is `node_body`, B is `polygon_body`.

namespace palpate::sim {
namespace {

/// Equation (1): u_temp = vector from F to a, which is perpendicular to S and points into B.
Vec3 temporary_displacement(const CollidingPair& pair) {
  return -pair.depth * pair.normal;
}

/// The polygon of A beside node a that faces S most squarely; of two alike the lower number.
int adjacent_polygon(const Body& body, const BodyMotion& motion, int node, const Vec3& normal_of_s) {
  const auto at = static_cast<std::size_t>(node);
  const int first = body.polygons.incident_begin[at];
  int adjacent = body.polygons.incident[first];
  double least = polygon_normal(body, motion, adjacent).dot(normal_of_s);
  for (int i = first + 1; i < body.polygons.incident_begin[at + 1]; ++i) {
    const int polygon = body.polygons.incident[i];
    const double alignment = polygon_normal(body, motion, polygon).dot(normal_of_s);
    if (alignment < least) {
      least = alignment;
      adjacent = polygon;
    }
  }
  return adjacent;
}

void ask_polygon(Scratch::Buffers& buffers, Claims BodyBuffers::*claims, const Model& model, int body,
                 int polygon, const Vec3& displacement, int touch_pair) {
  const auto at = static_cast<std::size_t>(body);
  for (const int node : model.bodies[at].polygons.triangles[polygon])
    (buffers.bodies[at].*claims).ask(node, displacement, touch_pair);
}

/// Equation (2) for every pair: with A rigid the corners P, Q, R of S follow u_temp; with B rigid the polygon
/// of A beside a yields by as much. (Where a node b of B has passed that polygon too, its own pair asks for F
/// -> b, and the larger of the two is taken.)
void ask_temporary(const Model& model, Scratch::Buffers& buffers) {
  for (const CollidingPair& pair : buffers.pairs) {
    const auto node_body = static_cast<std::size_t>(pair.node_body);
    const Vec3 u_temp = temporary_displacement(pair);
    ask_polygon(buffers, &BodyBuffers::temporary_claims, model, pair.polygon_body, pair.polygon, u_temp,
                pair.touch_pair);
    const int beside =
        adjacent_polygon(model.bodies[node_body], buffers.free_motion[node_body], pair.node, pair.normal);
    ask_polygon(buffers, &BodyBuffers::temporary_claims, model, pair.node_body, beside, -u_temp,
                pair.touch_pair);
  }
}

/// Steps 3 and 4: temporary deformation of each body, the other taken as rigid, and the surface forces it
/// takes.
bool deform_temporarily(const Model& model, Scratch::Buffers& buffers) {
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    BodyBuffers& body = buffers.bodies[i];
    body.temporary_claims.sort();
    body.temporary_forces.setZero();
    if (body.temporary_claims.nodes.empty()) continue;
    if (!body.temporary.factor(buffers.rows, body.temporary_claims.nodes)) return false;
    const auto multipliers = body.temporary.solve(nullptr, body.temporary_claims.displacement);
    const double* force = multipliers.data() + body.temporary.probe_rows();
    for (const int node : body.temporary_claims.nodes) {
      body.temporary_forces.segment<3>(3 * node) =
          model.bodies[i].young_modulus * Vec3(force[0], force[1], force[2]);
      force += 3;
    }
  }
  return true;
}

/// |f| of a polygon: the mean of the force vectors on its corners, projected onto its normal.
double surface_force(const Model& model, const Scratch::Buffers& buffers, int body, int polygon) {
  const auto at = static_cast<std::size_t>(body);
  Vec3 sum = Vec3::Zero();
  for (const int node : model.bodies[at].polygons.triangles[polygon])
    sum += buffers.bodies[at].temporary_forces.segment<3>(3 * node);
  return std::abs((sum / 3.0).dot(polygon_normal(model.bodies[at], buffers.free_motion[at], polygon)));
}

/// Resistance of S and of the polygon of A beside a: what the ratio of equations (3) and (4) is made of.
PairShare share_of(const Model& model, const Scratch::Buffers& buffers, const CollidingPair& pair) {
  const auto node_body = static_cast<std::size_t>(pair.node_body);
  const int beside =
      adjacent_polygon(model.bodies[node_body], buffers.free_motion[node_body], pair.node, pair.normal);
  return {.polygon_force = surface_force(model, buffers, pair.polygon_body, pair.polygon),
          .node_force = surface_force(model, buffers, pair.node_body, beside)};
}

bool is_held(const Scratch::Buffers& buffers, int body, int node) {
  return buffers.bodies[body].actual_claims.held[node] != 0;
}

/// The part of u_temp that the node gives way by: |f_B| / (|f_A| + |f_B|) of equation (3). What a probe holds
/// cannot give way at all, and leaves everything to the other side. Nothing where neither can.
std::optional<double> share_of_node(const Model& model, const Scratch::Buffers& buffers,
                                    const CollidingPair& pair, const PairShare& share) {
  const auto& corners = model.bodies[pair.polygon_body].polygons.triangles[pair.polygon];
  const bool node_held = is_held(buffers, pair.node_body, pair.node);
  const bool polygon_held =
      std::ranges::all_of(corners, [&](int corner) { return is_held(buffers, pair.polygon_body, corner); });
  if (node_held && polygon_held) return std::nullopt;
  if (node_held) return 0.0;
  if (polygon_held) return 1.0;
  const double sum = share.polygon_force + share.node_force;
  return sum > 0.0 ? std::optional(share.polygon_force / sum) : std::nullopt;
}

/// Equations (3) and (4): the node gives way by the polygon's share of the resistance, the polygon by the
/// node's.
void ask_actual(const Model& model, Scratch::Buffers& buffers, const CollidingPair& pair,
                const PairShare& share) {
  const Vec3 u_temp = temporary_displacement(pair);
  const std::optional<double> node_share = share_of_node(model, buffers, pair, share);
  if (!node_share) return;
  const Vec3 u_a = -*node_share * u_temp;
  const Vec3 u_b = (1.0 - *node_share) * u_temp;
  buffers.bodies[pair.node_body].actual_claims.ask(pair.node, u_a, pair.touch_pair);
  ask_polygon(buffers, &BodyBuffers::actual_claims, model, pair.polygon_body, pair.polygon, u_b,
              pair.touch_pair);
}

}  // namespace

SolveReport kuroda(const Model& model, Scratch::Buffers& buffers) {
  ask_temporary(model, buffers);
  if (!deform_temporarily(model, buffers)) return {.stop = Stop::SingularMatrix};
  buffers.shares.clear();
  for (const CollidingPair& pair : buffers.pairs) {
    buffers.shares.push_back(share_of(model, buffers, pair));
    ask_actual(model, buffers, pair, buffers.shares.back());
  }
  return {};
}

}  // namespace palpate::sim
