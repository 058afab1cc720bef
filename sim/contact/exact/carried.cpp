#include "sim/contact/exact/carried.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "sim/contact/exact/coupling.hpp"
#include "sim/pairing/outward.hpp"

namespace palpate::sim {
namespace {

constexpr double kFar = 1e30;        // [m], of a contact that is left out
constexpr double kSame = 1e-12;      // of a weight or a normal: less is rounding
constexpr double kFollows = 1.8;     // a length is at most sqrt(3) times its largest component
constexpr double kFirstLook = 0.02;  // of the largest body's size

bool is_carried(const Model& model, int body) {
  return std::ranges::any_of(model.bodies[body].probes, [&](int probe) {
    const auto& region = model.probes[probe].region;
    return region && region->carries;
  });
}

double size_of(const Body& body) {
  return (body.rest.rowwise().maxCoeff() - body.rest.rowwise().minCoeff()).norm();
}

/// ||C_ji|| is at most the norm of its nine entries.
std::vector<double> influence_of(const Body& body) {
  std::vector<double> most;
  most.reserve(static_cast<std::size_t>(body.rest.cols()));
  for (Eigen::Index node = 0; node < body.rest.cols(); ++node) {
    double largest = 0.0;
    for (const int moved : body.colliding_nodes)
      largest = std::max(largest, body.compliance->touch_touch.block<3, 3>(3 * moved, 3 * node).norm());
    most.push_back(largest);
  }
  return most;
}

void add_candidates(const Model& model, int touch_pair, int node_body, int polygon_body,
                    std::vector<FacingPair>& pairs) {
  for (const int node : model.bodies[node_body].colliding_nodes) {
    FacingPair pair{
        .touch_pair = touch_pair, .node_body = node_body, .node = node, .polygon_body = polygon_body};
    const Faces side = face_at_rest(model, pair);
    if (side == Faces::Back && !touches_at_rest(model, pair)) continue;
    pair.gap = side == Faces::Back ? -pair.gap : 0.0;
    pairs.push_back(pair);
  }
}

/// What regions that do not carry their bodies as a whole have done to a contact.
Vec3 moved_by_regions(const Model& model, const ProbeRows& probes, const FacingPair& pair) {
  Vec3 moved = Vec3::Zero();
  for (std::size_t p = 0; p < model.probes.size(); ++p) {
    const Probe& probe = model.probes[p];
    if (!probe.region || probe.region->carries) continue;
    for (Eigen::Index mode = 0; mode < 12; ++mode)
      if (const double by = probes[p].region[mode]; by != 0.0)
        moved += by * relative_motion(pair, probe.body, probe.region->touch_motion.col(mode));
  }
  return moved;
}

}  // namespace

bool carries_bodies(const Model& model) {
  return std::ranges::any_of(model.pairs, [&](const TouchPair& pair) {
    return is_carried(model, pair.bodies[0]) || is_carried(model, pair.bodies[1]);
  });
}

std::vector<FacingPair> carried_pairs(const Model& model) {
  std::vector<FacingPair> pairs;
  for (int p = 0; p < std::ssize(model.pairs); ++p) {
    const auto [a, b] = model.pairs[p].bodies;
    if (model.pairs[p].meets[0]) add_candidates(model, p, a, b, pairs);
    if (model.pairs[p].meets[1]) add_candidates(model, p, b, a, pairs);
  }
  return pairs;
}

Carried::Carried(const Model& model, std::span<const FacingPair> pairs)
    : turns(model.bodies.size(), Eigen::Matrix3d::Identity()),
      poses(model.bodies.size()),
      response(model),
      is_near(pairs.size()),
      known(pairs.size()),
      filled(pairs.size()),
      moved(model.bodies.size()) {
  for (const Body& body : model.bodies) {
    influence.push_back(influence_of(body));
    start = std::max(start, kFirstLook * size_of(body));
  }
  rest_overlap.reserve(pairs.size());
  looks.reserve(pairs.size());
  for (const FacingPair& pair : pairs) {
    const Body& body = model.bodies[pair.node_body];
    rest_overlap.push_back(pair.gap);
    looks.push_back(corner_normal(body.polygons, body.rest, pair.node));
  }
  far_until.resize(pairs.size());
  last.assign(pairs.size(), -1);
  near.reserve(pairs.size());
  renewed.reserve(pairs.size());
  within = start;
}

namespace {

/// The most that any place within a body's box goes between two poses: it is the most at a corner.
double way_between(const Body& body, const RigidPose& before, const RigidPose& after) {
  const AabbTree::Node& box = body.tree.nodes.front();
  double most = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 place = box.lower;
    for (int k = 0; k < 3; ++k)
      if (corner >> k & 1) place[k] = box.upper[k];
    const Vec3 apart = (after.rotation - before.rotation) * place + after.shift - before.shift;
    most = std::max(most, apart.norm());
  }
  return most;
}

}  // namespace

void carry(const Model& model, const ProbeRows& probes, Carried& carried) {
  for (std::size_t p = 0; p < model.probes.size(); ++p) {
    const Probe& probe = model.probes[p];
    if (!probe.region || !probe.region->carries) continue;
    const Eigen::Matrix3d turn = rotation_of(probes[p].region);
    const RigidPose pose{turn, probes[p].region.head<3>() + probe.at - turn * probe.at};
    if (turn != carried.turns[probe.body]) std::ranges::fill(carried.known, 0);
    if (!model.bodies[probe.body].tree.nodes.empty())
      carried.way += way_between(model.bodies[probe.body], carried.poses[probe.body], pose);
    carried.turns[probe.body] = turn;
    carried.poses[probe.body] = pose;
  }
}

namespace {

/// Whether two contacts differ by no more than rounding.
bool same(const FacingPair& a, const FacingPair& b) {
  return a.corners == b.corners && (a.weights - b.weights).lpNorm<Eigen::Infinity>() <= kSame &&
         (a.normal - b.normal).lpNorm<Eigen::Infinity>() <= kSame;
}

/// Sorts out what is known, and what has changed among the contacts that are near.
void find_renewed(Carried& carried, std::span<FacingPair> pairs) {
  carried.renewed.clear();
  for (const int i : carried.near)
    if (carried.known[i] && same(pairs[i], carried.filled[i]))
      pairs[i] = carried.filled[i];
    else
      carried.renewed.push_back(i);
  if (carried.renewed.empty()) return;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (!carried.is_near[i]) carried.known[i] = 0;
  for (const int i : carried.renewed) {
    carried.known[i] = 1;
    carried.filled[i] = pairs[i];
  }
}

/// A contact's node as the polygon's body sees it.
Vec3 place_of(const Model& model, const Carried& carried, const FacingPair& pair) {
  const RigidPose &node = carried.poses[pair.node_body], &polygon = carried.poses[pair.polygon_body];
  const Vec3 there = node.rotation * model.bodies[pair.node_body].rest.col(pair.node) + node.shift;
  return polygon.rotation.transpose() * (there - polygon.shift);
}

/// How far a place is from a polygon of a body, rounded up: nothing that is farther can be the nearest one.
double distance_to(const Body& polygons, int polygon, const Vec3& place) {
  if (polygon < 0) return std::numeric_limits<double>::infinity();
  const auto [a, b, c] = polygons.polygons.triangles[polygon];
  const Vec3 nearest =
      nearest_on_triangle(place, polygons.rest.col(a), polygons.rest.col(b), polygons.rest.col(c)).point;
  return (nearest - place).norm() + rounding_of(polygons.tree);
}

/// Sets what a contact faces. @return false where it is not near, or faces nothing
bool comes_near(const Model& model, Carried& carried, std::size_t contact, FacingPair& pair) {
  if (carried.far_until[contact] - carried.way > carried.within) return false;
  const Body& polygons = model.bodies[pair.polygon_body];
  const Vec3 place = place_of(model, carried, pair);
  const double within = std::min(carried.within, distance_to(polygons, carried.last[contact], place));
  const NearestPolygon found = nearest_of(polygons, place, within);
  carried.last[contact] = found.polygon;
  if (found.polygon < 0) {
    const NearestPolygon far = nearest_of(polygons, place, std::numeric_limits<double>::infinity());
    carried.far_until[contact] = carried.way + std::sqrt(far.squared_distance);
    return false;
  }
  const Vec3 looks =
      carried.turns[pair.polygon_body].transpose() * (carried.turns[pair.node_body] * carried.looks[contact]);
  return face(polygons, found, place, looks, pair) != Faces::Nothing;
}

}  // namespace

void meet(const Model& model, const ProbeRows& probes, Carried& carried, std::span<FacingPair> pairs,
          std::span<double> gaps) {
  carried.near.clear();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    FacingPair& pair = pairs[i];
    gaps[i] = kFar;
    carried.is_near[i] = 0;
    if (!comes_near(model, carried, i, pair)) continue;
    const double gap = pair.gap + carried.rest_overlap[i];
    pair.normal = carried.poses[pair.polygon_body].rotation * pair.normal;
    carried.is_near[i] = 1;
    carried.near.push_back(static_cast<int>(i));
    gaps[i] = gap;
  }
  find_renewed(carried, pairs);
  for (const int i : carried.near) gaps[i] += pairs[i].normal.dot(moved_by_regions(model, probes, pairs[i]));
}

Vec3 gone(const Model& model, const ProbeRows& probes, const Carried& carried, const FacingPair& pair) {
  return place_of(model, carried, pair) - model.bodies[pair.node_body].rest.col(pair.node) +
         carried.turns[pair.polygon_body].transpose() * moved_by_regions(model, probes, pair);
}

void forget(Carried& carried) {
  carried.within = carried.start;
  carried.way = 0.0;
  std::ranges::fill(carried.poses, RigidPose{});
  std::ranges::fill(carried.turns, Eigen::Matrix3d(Eigen::Matrix3d::Identity()));
  std::ranges::fill(carried.far_until, 0.0);
  std::ranges::fill(carried.last, -1);
  std::ranges::fill(carried.known, 0);
}

void begin_giving_way(Carried& carried) {
  std::ranges::fill(carried.moved, 0.0);
}

namespace {

void push(const Model& model, int body, int node, double force, Carried& carried) {
  carried.moved[body] += carried.influence[body][node] * std::abs(force) / model.bodies[body].young_modulus;
}

}  // namespace

void give_way(const Model& model, const FacingPair& pair, double force, Carried& carried) {
  push(model, pair.node_body, pair.node, force, carried);
  if (pair.polygon_body == kRigid) return;
  for (std::size_t k = 0; k < 3; ++k)
    push(model, pair.polygon_body, pair.corners[k], pair.weights[static_cast<Eigen::Index>(k)] * force,
         carried);
}

void give_way(const Model& model, const ProbeRows& probes, std::span<const double> forces, Carried& carried) {
  auto force = forces.begin();
  for (std::size_t p = 0; p < model.probes.size(); ++p) {
    const Probe& probe = model.probes[p];
    const std::span<const double> weights = weights_of(probe, probes[p]);
    for (Eigen::Index axis = 0; axis < probe.axes.cols(); ++axis, ++force)
      for (std::size_t i = 0; i < probe.nodes.size(); ++i)
        push(model, probe.body, probe.nodes[i], weights[i] * *force, carried);
    if (!probe.region || probe.region->carries) continue;
    for (Eigen::Index mode = 0; mode < 12; ++mode)
      carried.moved[probe.body] += kFollows * std::abs(probes[p].region[mode]) *
                                   probe.region->touch_motion.col(mode).lpNorm<Eigen::Infinity>();
  }
}

bool looked_far_enough(Carried& carried) {
  std::ranges::sort(carried.moved, std::greater());
  const double needed = carried.moved[0] + (carried.moved.size() > 1 ? carried.moved[1] : 0.0);
  const bool enough =
      !(needed > carried.within);  // what is no number is told by the forces; it is not looked for
  if (!enough || 2.5 * needed < carried.within) carried.within = std::max(carried.start, 1.5 * needed);
  return enough;
}

}  // namespace palpate::sim
