#include "sim/probe/footprint.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

namespace palpate::sim {
namespace {

[[noreturn]] void refuse(const ProbeSpec& spec, const std::string& what) {
  throw std::invalid_argument(fmt::format("probes.{}: {}", spec.name, what));
}

int node_of_tag(const ProbeSpec& spec, const TetMesh& mesh, std::int64_t tag) {
  const auto found = std::ranges::find(mesh.node_tags, tag);
  if (found == mesh.node_tags.end())
    refuse(spec,
           fmt::format(
               "the mesh of {} has no node number {}; accepted: a number of the mesh file, or at = [...]",
               spec.body, tag));
  return static_cast<int>(found - mesh.node_tags.begin());
}

int nearest_surface_node(const ProbeSpec& spec, const TetMesh& mesh, const Surface& surface,
                         const Vec3& place) {
  Vec3 lower = mesh.nodes[surface.nodes.front()], upper = lower;
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const int node : surface.nodes) {
    const Vec3& here = mesh.nodes[node];
    lower = lower.cwiseMin(here);
    upper = upper.cwiseMax(here);
    const double squared = (here - place).squaredNorm();
    if (squared < least) {
      least = squared;
      nearest = node;
    }
  }
  const double size = (upper - lower).norm();
  if (!(std::sqrt(least) <= size))
    refuse(spec,
           fmt::format("at: is {:g} m away from {}, which is {:g} m across; accepted: a place at its surface",
                       (0.5 * (lower + upper) - place).stableNorm(), spec.body, size));
  return nearest;
}

/// Nodes within the radius that are reached from the middle along edges of the surface between nodes within
/// it.
std::set<int> connected_footprint(const TetMesh& mesh, const Surface& surface, int middle, double radius) {
  const Vec3 centre = mesh.nodes[middle];
  const auto within = [&](int node) { return (mesh.nodes[node] - centre).norm() < radius; };
  std::set<int> footprint{middle};
  for (std::size_t before = 0; before != footprint.size();) {
    before = footprint.size();
    for (const Triangle& corners : surface.triangles)
      if (std::ranges::any_of(corners, [&](int node) { return footprint.contains(node); }))
        for (const int node : corners)
          if (within(node)) footprint.insert(node);
  }
  return footprint;
}

std::map<int, double> surface_area_of_nodes(const TetMesh& mesh, const Surface& surface) {
  std::map<int, double> area;
  for (const Triangle& corners : surface.triangles) {
    const Vec3 a = mesh.nodes[corners[0]], b = mesh.nodes[corners[1]], c = mesh.nodes[corners[2]];
    for (const int node : corners) area[node] += (b - a).cross(c - a).norm() / 6.0;
  }
  return area;
}

void spread_pad(const ProbeSpec& spec, const TetMesh& mesh, const Surface& surface, int middle,
                Probe& probe) {
  const auto area = surface_area_of_nodes(mesh, surface);
  const Vec3 centre = mesh.nodes[middle];
  double sum = 0.0;
  for (const int node : connected_footprint(mesh, surface, middle, spec.radius)) {
    const double distance = (mesh.nodes[node] - centre).norm() / spec.radius;
    probe.nodes.push_back(node);
    probe.weights.push_back(area.at(node) * (1.0 - distance * distance));
    sum += probe.weights.back();
  }
  for (double& weight : probe.weights) weight /= sum;
}

}  // namespace

void footprint(const Model& model, Pose pose, ProbeRows& rows) {
  for (std::size_t i = 0; i < model.probes.size(); ++i) {
    const Probe& probe = model.probes[i];
    const Vec3& displacement = pose[i].displacement;
    rows[i].pressing = displacement.dot(probe.direction) > 0.0;
    rows[i].value.setZero();
    for (Eigen::Index k = 0; k < probe.axes.cols(); ++k)
      rows[i].value[k] = probe.axes.col(k).dot(displacement);
  }
}

void place_probe(const ProbeSpec& spec, const TetMesh& mesh, const Surface& surface,
                 const std::vector<int>& fixed, Probe& probe) {
  const auto* tag = std::get_if<std::int64_t>(&spec.at);
  const int middle = tag ? node_of_tag(spec, mesh, *tag)
                         : nearest_surface_node(spec, mesh, surface, std::get<Vec3>(spec.at));
  if (!std::ranges::binary_search(surface.nodes, middle))
    refuse(spec, fmt::format("node {} lies inside {}; accepted: a node of its surface", *tag, spec.body));
  if (spec.kind == ProbeKind::Pad) {
    spread_pad(spec, mesh, surface, middle, probe);
  } else {
    probe.nodes = {middle};
    probe.weights = {1.0};
  }
  probe.at.setZero();
  for (std::size_t i = 0; i < probe.nodes.size(); ++i) {
    const auto node = static_cast<std::size_t>(probe.nodes[i]);
    if (std::ranges::binary_search(fixed, probe.nodes[i]))
      refuse(spec, fmt::format("it would hold node {} of {}, which is fixed; move it away from the supports",
                               mesh.node_tags[node], spec.body));
    probe.at += probe.weights[i] * mesh.nodes[node];
  }
}

}  // namespace palpate::sim
