#include "sim/probe/pad/pad.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>

#include "sim/probe/mean/mean.hpp"

namespace palpate::sim {
namespace {

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

constinit const ProbeKind kPad{
    .keys = {.name = "pad",
             .meaning = "the pad of a finger: the surface within `radius` of it, most in the middle",
             .takes_radius = true},
    .hold = spread_pad,
    .prescribe = prescribe_mean};

}  // namespace palpate::sim
