#include "sim/probe/pad/pad.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "sim/probe/mean/mean.hpp"
#include "sim/probe/skin/skin.hpp"
#include "sim/probe/slide/slide.hpp"
#include "sim/scene/refuse_key.hpp"

namespace palpate::sim {
namespace {

/// Weights of a pad whose middle is at a node: area times 1 - (distance / radius)^2, their sum 1.
std::map<int, double> footprint(const Skin& surface, int middle, double radius) {
  const Vec3 centre = surface.mesh.nodes[middle];
  const auto distance = [&](int node) { return (surface.mesh.nodes[node] - centre).norm() / radius; };
  std::map<int, double> weights;
  double sum = 0.0;
  for (const int node : connected(surface, middle, [&](int other) { return distance(other) < 1.0; })) {
    weights[node] = surface.area.at(node) * (1.0 - distance(node) * distance(node));
    sum += weights[node];
  }
  for (auto& [node, weight] : weights) weight /= sum;
  return weights;
}

/// The polygons that face the probe within its reach, and their corners as knots. @return the knots' nodes
std::vector<int> spread_slide(const ProbeSpec& spec, const Skin& described, const Surface& surface,
                              int middle, Slide& slide) {
  const TetMesh& mesh = described.mesh;
  std::map<int, int> knot_of_node;
  // one polygon beyond the reach, so that the way to its end lies within polygons
  const std::set<int> near =
      connected(described, middle, [&](int node) { return across(spec, mesh, middle, node) < spec.reach; });
  for (const Triangle& corners : surface.triangles) {
    const Vec3 a = mesh.nodes[corners[0]], b = mesh.nodes[corners[1]], c = mesh.nodes[corners[2]];
    const bool touches = std::ranges::any_of(corners, [&](int node) { return near.contains(node); });
    if (!touches || (b - a).cross(c - a).dot(spec.direction) >= 0.0) continue;
    Triangle knots{};
    for (std::size_t k = 0; k < corners.size(); ++k)
      knots[k] = knot_of_node.try_emplace(corners[k], static_cast<int>(knot_of_node.size())).first->second;
    slide.triangles.push_back(knots);
  }
  if (!knot_of_node.contains(middle))
    refuse_key(fmt::format("probes.{}.direction", spec.name),
               fmt::format(
                   "the surface of {} does not face it there, so the pad cannot slide; accepted: a direction "
                   "into the body, or the pad without reach",
                   spec.body));
  std::vector<int> nodes(knot_of_node.size());
  for (const auto& [node, knot] : knot_of_node) nodes[knot] = node;
  return nodes;
}

void hold_pad(const ProbeSpec& spec, const TetMesh& mesh, const Surface& surface, int middle, Probe& probe) {
  const Skin described = skin_of(mesh, surface);
  refuse_smaller_than_mesh(spec, described, middle);
  std::vector<int> knots;
  if (spec.reach > 0.0) {
    knots = spread_slide(spec, described, surface, middle, probe.slide);
    probe.slide.start = mesh.nodes[middle];
  }
  std::vector<std::map<int, double>> prints;
  prints.reserve(knots.size());
  for (const int knot : knots) prints.push_back(footprint(described, knot, spec.radius));
  const std::map<int, double> here = footprint(described, middle, spec.radius);
  std::set<int> all;
  for (const auto& print : prints)
    for (const auto& [node, weight] : print) all.insert(node);
  for (const auto& [node, weight] : here) all.insert(node);
  for (const int node : all) {
    probe.nodes.push_back(node);
    probe.weights.push_back(here.contains(node) ? here.at(node) : 0.0);
  }
  probe.slide.knots.reserve(knots.size());
  for (std::size_t k = 0; k < knots.size(); ++k) {
    Knot knot{.place = mesh.nodes[knots[k]], .weights = Eigen::VectorXd::Zero(std::ssize(probe.nodes))};
    for (std::size_t i = 0; i < probe.nodes.size(); ++i)
      if (const auto found = prints[k].find(probe.nodes[i]); found != prints[k].end())
        knot.weights[static_cast<Eigen::Index>(i)] = found->second;
    probe.slide.knots.push_back(std::move(knot));
  }
}

void prescribe_pad(const Probe& probe, const ProbeDisplacement& displacement, ProbeRow& row) {
  if (probe.slide.knots.empty())
    prescribe_mean(probe, displacement, row);
  else
    prescribe_sliding(probe, displacement, row);
}

}  // namespace

constinit const ProbeKind kPad{
    .keys =
        {.name = "pad",
         .meaning =
             "the pad of a finger: the surface within `radius` of it, most in the middle; it slides where "
             "it has a `reach`",
         .takes_radius = true,
         .takes_reach = true,
         .holds_mean = true},
    .hold = hold_pad,
    .prescribe = prescribe_pad};

}  // namespace palpate::sim
