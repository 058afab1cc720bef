#include "sim/contact/exact/tip_rows.hpp"

#include <algorithm>

#include "sim/contact/exact/contact_system.hpp"
#include "sim/probe/fingertip/fingertip.hpp"

namespace palpate::sim {
namespace {

constexpr double kBeside = 1e30;  // [m], the gap of a node that is not below a sphere

}  // namespace

TipRows::TipRows(const Model& model, std::size_t contacts)
    : turns(model.bodies.size(), Eigen::Matrix3d::Identity()), response(model) {
  near.reserve(contacts);
  with.reserve(contacts);
}

bool has_tips(const Model& model) {
  return std::ranges::any_of(model.probes, [](const Probe& probe) { return probe.tip != nullptr; });
}

std::size_t add_tips(const Model& model, std::vector<FacingPair>& pairs) {
  const std::size_t first = pairs.size();
  for (int p = 0; p < std::ssize(model.probes); ++p)
    if (model.probes[p].tip)
      for (const int node : model.probes[p].tip->nodes)
        pairs.push_back(
            {.touch_pair = p, .node_body = model.probes[p].body, .node = node, .polygon_body = kRigid});
  return first;
}

void bring_tips(const Model& model, const ProbeRows& probes, std::size_t first_tip,
                std::span<const int> between_bodies, std::span<const Eigen::Matrix3d> turns,
                std::span<FacingPair> pairs, std::span<double> gaps, TipRows& rows, ContactSystem& system) {
  rows.near.clear();
  for (std::size_t i = first_tip; i < pairs.size(); ++i) {
    FacingPair& pair = pairs[i];
    const Probe& probe = model.probes[pair.touch_pair];
    gaps[i] = kBeside;
    if (!meet_tip(model.bodies[pair.node_body], *probe.tip, probe.direction, probes[pair.touch_pair].centre,
                  pair))
      continue;
    gaps[i] = pair.gap;
    rows.near.push_back(static_cast<int>(i));
  }
  rows.with.assign(between_bodies.begin(), between_bodies.end());
  rows.with.insert(rows.with.end(), rows.near.begin(), rows.near.end());
  fill_contacts(model, probes, turns.empty() ? std::span<const Eigen::Matrix3d>(rows.turns) : turns, pairs,
                rows.near, rows.with, rows.response, system);
}

}  // namespace palpate::sim
