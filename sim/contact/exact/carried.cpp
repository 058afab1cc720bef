#include "sim/contact/exact/carried.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "sim/contact/exact/contact_system.hpp"

namespace palpate::sim {
namespace {

constexpr double kFar = 1e30;        // [m], of a contact that is left out
constexpr double kSame = 1e-12;      // of a weight or a normal: less is rounding
constexpr double kFollows = 1.8;     // a length is at most sqrt(3) times its largest component
constexpr double kFirstLook = 0.02;  // of the largest body's size

bool is_carried(const Model& model, int body) {
  return std::ranges::any_of(model.bodies[body].probes, [&](int probe) {
    const auto& region = model.probes[probe].region;
    return region && region->alone;
  });
}

double size_of(const Body& body) {
  return (body.rest.rowwise().maxCoeff() - body.rest.rowwise().minCoeff()).norm();
}

/// ||C_ji|| is at most the norm of its nine entries.
std::vector<double> influence_of(const Body& body) {
  std::vector<double> most;
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
    const Faces side = face(model.bodies[node_body], model.bodies[polygon_body], {},
                            std::numeric_limits<double>::infinity(), pair);
    if (side == Faces::Back && !touches_at_rest(model, pair)) continue;
    pair.gap = side == Faces::Back ? -pair.gap : 0.0;
    pairs.push_back(pair);
  }
}

/// The first body's place as the second sees it.
RigidPose seen_from(const RigidPose& first, const RigidPose& second) {
  return {second.rotation.transpose() * first.rotation,
          second.rotation.transpose() * (first.shift - second.shift)};
}

/// What regions that do not carry their bodies as a whole have done to a gap.
double moved_by_regions(const Model& model, const ProbeRows& probes, const FacingPair& pair) {
  double moved = 0.0;
  for (std::size_t p = 0; p < model.probes.size(); ++p) {
    const Probe& probe = model.probes[p];
    if (!probe.region || probe.region->alone) continue;
    for (Eigen::Index mode = 0; mode < 12; ++mode)
      if (const double by = probes[p].region[mode]; by != 0.0)
        moved += by * opened_by(pair, probe.body, probe.region->touch_motion.col(mode));
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
      is_near(pairs.size()),
      known(pairs.size()),
      filled(pairs.size()),
      moved(model.bodies.size()) {
  for (const Body& body : model.bodies) {
    influence.push_back(influence_of(body));
    start = std::max(start, kFirstLook * size_of(body));
  }
  for (const FacingPair& pair : pairs) rest_overlap.push_back(pair.gap);
  near.reserve(pairs.size());
  renewed.reserve(pairs.size());
  within = start;
}

void carry(const Model& model, const ProbeRows& probes, Carried& carried) {
  for (std::size_t p = 0; p < model.probes.size(); ++p) {
    const Probe& probe = model.probes[p];
    if (!probe.region || !probe.region->alone) continue;
    const Eigen::Matrix3d turn = rotation_of(probes[p].region);
    if (turn != carried.turns[probe.body]) std::ranges::fill(carried.known, 0);
    carried.turns[probe.body] = turn;
    carried.poses[probe.body] = {turn, probes[p].region.head<3>() + probe.at - turn * probe.at};
  }
}

namespace {

/// Whether two contacts differ by no more than rounding.
bool same(const FacingPair& a, const FacingPair& b) {
  return a.corners == b.corners && (a.weights - b.weights).lpNorm<Eigen::Infinity>() <= kSame &&
         (a.normal - b.normal).lpNorm<Eigen::Infinity>() <= kSame;
}

/// Fills what is not known, or has changed, among the contacts that are near.
bool fill_changed(const Model& model, const ProbeRows& probes, Carried& carried, std::span<FacingPair> pairs,
                  ContactSystem& system) {
  carried.renewed.clear();
  for (const int i : carried.near)
    if (carried.known[i] && same(pairs[i], carried.filled[i]))
      pairs[i] = carried.filled[i];
    else
      carried.renewed.push_back(i);
  if (carried.renewed.empty()) return false;
  for (std::size_t i = 0; i < pairs.size(); ++i) carried.known[i] = carried.known[i] && carried.is_near[i];
  for (const int i : carried.renewed) {
    carried.known[i] = 1;
    carried.filled[i] = pairs[i];
  }
  fill_contacts(model, probes, carried.turns, pairs, carried.renewed, carried.near, system);
  return true;
}

}  // namespace

bool meet(const Model& model, const ProbeRows& probes, Carried& carried, std::span<FacingPair> pairs,
          std::span<double> gaps, ContactSystem& system) {
  carried.near.clear();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    FacingPair& pair = pairs[i];
    gaps[i] = kFar;
    carried.is_near[i] = 0;
    const RigidPose& below = carried.poses[pair.polygon_body];
    const RigidPose seen = seen_from(carried.poses[pair.node_body], below);
    if (face(model.bodies[pair.node_body], model.bodies[pair.polygon_body], seen, carried.within, pair) ==
        Faces::Nothing)
      continue;
    pair.normal = below.rotation * pair.normal;
    gaps[i] = pair.gap + carried.rest_overlap[i] + moved_by_regions(model, probes, pair);
    carried.is_near[i] = 1;
    carried.near.push_back(static_cast<int>(i));
  }
  return fill_changed(model, probes, carried, pairs, system);
}

bool looked_far_enough(const Model& model, const ProbeRows& probes, std::span<const FacingPair> pairs,
                       const ContactSystem& system, const ComplementaritySolve& solve, Carried& carried) {
  std::ranges::fill(carried.moved, 0.0);
  const auto push = [&](int body, int node, double force) {
    carried.moved[body] += carried.influence[body][node] * std::abs(force) / model.bodies[body].young_modulus;
  };
  for (const int row : solve.active().subspan(solve.holding())) {
    const FacingPair& pair = pairs[static_cast<std::size_t>(row - system.bilateral)];
    push(pair.node_body, pair.node, solve.forces()[row]);
    for (std::size_t k = 0; k < 3; ++k)
      push(pair.polygon_body, pair.corners[k],
           pair.weights[static_cast<Eigen::Index>(k)] * solve.forces()[row]);
  }
  for (std::size_t p = 0; p < model.probes.size(); ++p) {
    const Probe& probe = model.probes[p];
    const std::span<const double> weights = weights_of(probe, probes[p]);
    for (Eigen::Index axis = 0; axis < probe.axes.cols(); ++axis)
      for (std::size_t i = 0; i < probe.nodes.size(); ++i)
        push(probe.body, probe.nodes[i], weights[i] * solve.forces()[system.first_of_probe[p] + axis]);
    if (!probe.region || probe.region->alone) continue;
    for (Eigen::Index mode = 0; mode < 12; ++mode)
      carried.moved[probe.body] += kFollows * std::abs(probes[p].region[mode]) *
                                   probe.region->touch_motion.col(mode).lpNorm<Eigen::Infinity>();
  }
  std::ranges::sort(carried.moved, std::greater());
  const double needed = carried.moved[0] + (carried.moved.size() > 1 ? carried.moved[1] : 0.0);
  if (needed <= carried.within) return true;
  carried.within = 1.5 * needed;
  return false;
}

}  // namespace palpate::sim
