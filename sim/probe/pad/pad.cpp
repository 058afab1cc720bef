#include "sim/probe/pad/pad.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "sim/probe/mean/mean.hpp"
#include "sim/probe/slide/slide.hpp"
#include "sim/scene/refuse_key.hpp"

namespace palpate::sim {
namespace {

struct SurfaceOfBody {
  const TetMesh& mesh;
  std::map<int, std::vector<int>> neighbours{};  // of each surface node, itself too
  std::map<int, double> area{};                  // its share of the surface
};

SurfaceOfBody describe(const TetMesh& mesh, const Surface& surface) {
  SurfaceOfBody described{.mesh = mesh};
  for (const Triangle& corners : surface.triangles) {
    const Vec3 a = mesh.nodes[corners[0]], b = mesh.nodes[corners[1]], c = mesh.nodes[corners[2]];
    for (const int node : corners) {
      described.area[node] += (b - a).cross(c - a).norm() / 6.0;
      std::vector<int>& beside = described.neighbours[node];
      beside.insert(beside.end(), corners.begin(), corners.end());
    }
  }
  return described;
}

/// Nodes that `within` accepts and that are reached from the middle along edges of the surface between such nodes.
template <class Within>
std::set<int> connected(const SurfaceOfBody& surface, int middle, const Within& within) {
  std::set<int> found{middle};
  std::vector<int> next{middle};
  while (!next.empty()) {
    const int from = next.back();
    next.pop_back();
    for (const int node : surface.neighbours.at(from))
      if (within(node) && found.insert(node).second) next.push_back(node);
  }
  return found;
}

/// Weights of a pad whose middle is at a node: area times 1 - (distance / radius)^2, their sum 1.
std::map<int, double> footprint(const SurfaceOfBody& surface, int middle, double radius) {
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

void refuse_small(const ProbeSpec& spec, const SurfaceOfBody& surface, int middle) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const int node : surface.neighbours.at(middle))
    if (node != middle)
      nearest = std::min(nearest, (surface.mesh.nodes[node] - surface.mesh.nodes[middle]).norm());
  if (spec.radius <= nearest)
    refuse_key(
        fmt::format("probes.{}.radius", spec.name),
        fmt::format(
            "a pad of {:.3g} mm is smaller than the mesh of {} there, whose next node is {:.3g} mm away; "
            "accepted: more than that (twice as much for a force that does not hang on the mesh), or "
            "kind = \"point\"",
            1e3 * spec.radius, spec.body, 1e3 * nearest));
}

/// How far a node is from the line of the press through the middle.
double across(const ProbeSpec& spec, const TetMesh& mesh, int middle, int node) {
  return (mesh.nodes[node] - mesh.nodes[middle]).cross(spec.direction).norm();
}

/// The polygons that face the probe within its reach, and their corners as knots. @return the knots' nodes
std::vector<int> spread_slide(const ProbeSpec& spec, const SurfaceOfBody& described, const Surface& surface,
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
  const SurfaceOfBody described = describe(mesh, surface);
  refuse_small(spec, described, middle);
  std::vector<int> knots;
  if (spec.reach > 0.0) {
    knots = spread_slide(spec, described, surface, middle, probe.slide);
    probe.slide.start = mesh.nodes[middle];
  }
  std::vector<std::map<int, double>> prints;
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
         .takes_reach = true},
    .hold = hold_pad,
    .prescribe = prescribe_pad};

}  // namespace palpate::sim
