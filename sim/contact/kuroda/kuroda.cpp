#include "sim/contact/kuroda/kuroda.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

// Symbols of the paper: a node a of body A has passed polygon S of body B; F is the foot of the perpendicular
// from a to the plane of S. Here A is `node_body`, B is `polygon_body`.

namespace palpate::sim {
namespace {

/// Equation (1): u_temp = vector from F to a, which is perpendicular to S and points into B.
Vec3 temporary_displacement(const CollidingPair& pair) {
  return -pair.depth * pair.normal;
}

/// Cosines of angles that differ by less count as alike: which polygon is taken must not hang on rounding, or the same
/// scene turned round would give another force.
constexpr double kAlike = 1e-9;

/// The polygon of A beside node a that faces S most squarely; of two alike the lower number.
int adjacent_polygon(const Body& body, PlacedBody& placed, int node, const Vec3& normal_of_s) {
  const int first = body.polygons.incident_begin[node];
  int adjacent = body.polygons.incident[first];
  double least = polygon_normal(body, placed, adjacent).dot(normal_of_s);
  for (int i = first + 1; i < body.polygons.incident_begin[node + 1]; ++i) {
    const int polygon = body.polygons.incident[i];
    const double alignment = polygon_normal(body, placed, polygon).dot(normal_of_s);
    if (alignment < least - kAlike) {
      least = alignment;
      adjacent = polygon;
    }
  }
  return adjacent;
}

/// The polygon of A beside a, for every pair.
void find_adjacent_polygons(const Model& model, KurodaScratch& scratch) {
  scratch.beside.clear();
  for (const CollidingPair& pair : scratch.pairs)
    scratch.beside.push_back(adjacent_polygon(model.bodies[pair.node_body], scratch.placement[pair.node_body],
                                              pair.node, pair.normal));
}

void ask_polygon(const Body& body, int polygon, const Vec3& displacement, int touch_pair, Claims& claims) {
  for (const int node : body.polygons.triangles[polygon]) claims.ask(node, displacement, touch_pair);
}

/// Equation (2) for every pair: with A rigid the corners P, Q, R of S follow u_temp; with B rigid the polygon
/// of A beside a yields by as much. (Where a node b of B has passed that polygon too, its own pair asks for F
/// -> b, and the larger of the two is taken.)
void ask_temporary(const Model& model, KurodaScratch& scratch) {
  for (std::size_t i = 0; i < scratch.pairs.size(); ++i) {
    const CollidingPair& pair = scratch.pairs[i];
    const Vec3 u_temp = temporary_displacement(pair);
    ask_polygon(model.bodies[pair.polygon_body], pair.polygon, u_temp, pair.touch_pair,
                scratch.temporary[pair.polygon_body].claims);
    ask_polygon(model.bodies[pair.node_body], scratch.beside[i], -u_temp, pair.touch_pair,
                scratch.temporary[pair.node_body].claims);
  }
}

/// Steps 3 and 4: temporary deformation of each body, the other taken as rigid, and the surface forces it
/// takes.
bool deform_temporarily(const Model& model, const ProbeRows& probes, KurodaScratch& scratch) {
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    auto& [solve, claims, forces] = scratch.temporary[i];
    claims.sort();
    forces.setZero();
    if (claims.nodes.empty()) continue;
    if (!solve.factor(probes, claims.nodes)) return false;
    const auto multipliers = solve.solve(nullptr, claims.displacement);
    const double* force = multipliers.data() + solve.probe_rows();
    for (const int node : claims.nodes) {
      forces.segment<3>(3 * node) = model.bodies[i].young_modulus * Vec3(force[0], force[1], force[2]);
      force += 3;
    }
  }
  return true;
}

/// |f| of a polygon: the mean of the force vectors on its corners, projected onto its normal.
double surface_force(const Model& model, KurodaScratch& scratch, int body, int polygon) {
  Vec3 sum = Vec3::Zero();
  for (const int node : model.bodies[body].polygons.triangles[polygon])
    sum += scratch.temporary[body].forces.segment<3>(3 * node);
  return std::abs((sum / 3.0).dot(polygon_normal(model.bodies[body], scratch.placement[body], polygon)));
}

/// Resistance of S and of the polygon of A beside a: what the ratio of equations (3) and (4) is made of.
PairShare share_of(const Model& model, KurodaScratch& scratch, const CollidingPair& pair, int beside) {
  return {.polygon_force = surface_force(model, scratch, pair.polygon_body, pair.polygon),
          .node_force = surface_force(model, scratch, pair.node_body, beside)};
}

bool is_held(const KurodaScratch& scratch, int body, int node) {
  return scratch.bodies[body].claims.held[node] != 0;
}

/// The part of u_temp that the node gives way by: |f_B| / (|f_A| + |f_B|) of equation (3). What a probe holds
/// cannot give way at all, and leaves everything to the other side. Nothing where neither can.
std::optional<double> share_of_node(const Model& model, const KurodaScratch& scratch,
                                    const CollidingPair& pair, const PairShare& share) {
  const auto& corners = model.bodies[pair.polygon_body].polygons.triangles[pair.polygon];
  const bool node_held = is_held(scratch, pair.node_body, pair.node);
  const bool polygon_held =
      std::ranges::all_of(corners, [&](int corner) { return is_held(scratch, pair.polygon_body, corner); });
  if (node_held && polygon_held) return std::nullopt;
  if (node_held) return 0.0;
  if (polygon_held) return 1.0;
  const double sum = share.polygon_force + share.node_force;
  return sum > 0.0 ? std::optional(share.polygon_force / sum) : std::nullopt;
}

/// Equations (3) and (4): the node gives way by the polygon's share of the resistance, the polygon by the
/// node's. Read literally, only where S is the one of the two polygons with the larger force: else that of A moves, with
/// the node of B that has passed it, which is a pair of its own or none.
void ask_actual(const Model& model, const CollidingPair& pair, const PairShare& share,
                KurodaScratch& scratch) {
  const Vec3 u_temp = temporary_displacement(pair);
  const std::optional<double> node_share = share_of_node(model, scratch, pair, share);
  if (!node_share) return;
  const bool neither_held = *node_share > 0.0 && *node_share < 1.0;
  if (model.reading == Reading::Literal && neither_held && share.polygon_force < share.node_force) return;
  const Vec3 u_a = -*node_share * u_temp;
  const Vec3 u_b = (1.0 - *node_share) * u_temp;
  scratch.bodies[pair.node_body].claims.ask(pair.node, u_a, pair.touch_pair);
  ask_polygon(model.bodies[pair.polygon_body], pair.polygon, u_b, pair.touch_pair,
              scratch.bodies[pair.polygon_body].claims);
}

SolveReport solve_kuroda(const Model& model, const FreeState& free, std::span<const double>,
                         LawScratch& scratch, Response& response) {
  auto& own = static_cast<KurodaScratch&>(scratch);
  own.shares.clear();
  if (!find_contacts(model, free, own)) return {};
  for (int i = 0; i < std::ssize(model.bodies); ++i) {
    Claims& claims = own.temporary[i].claims;
    claims.clear();
    hold_probed_nodes(model, free.probes, i, claims);
  }
  find_adjacent_polygons(model, own);
  ask_temporary(model, own);
  if (!deform_temporarily(model, free.probes, own)) return {.stop = Stop::SingularMatrix};
  for (std::size_t i = 0; i < own.pairs.size(); ++i) {
    own.shares.push_back(share_of(model, own, own.pairs[i], own.beside[i]));
    ask_actual(model, own.pairs[i], own.shares.back(), own);
  }
  return apply_claims(model, free, own, response);
}

}  // namespace

KurodaScratch::KurodaScratch(const Model& model) : PrescribedScratch(model) {
  beside.reserve(most_pairs(model));
  shares.reserve(most_pairs(model));
  temporary.reserve(model.bodies.size());
  for (int i = 0; i < std::ssize(model.bodies); ++i) {
    const std::size_t nodes = model.bodies[i].compliance->touch.size();
    temporary.push_back({contact_solve(model, i), Claims(nodes),
                         Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(nodes))});
  }
}

constinit const ContactLaw kKuroda{
    .name = "kuroda",
    .meaning = "they share their displacement by their stiffness (Kuroda et al. 2003)",
    .prepare = prepare_where_bodies_touch<KurodaScratch>,
    .solve = solve_kuroda};

}  // namespace palpate::sim
