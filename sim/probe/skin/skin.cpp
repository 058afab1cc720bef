#include "sim/probe/skin/skin.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "sim/scene/refuse_key.hpp"

namespace palpate::sim {

Skin skin_of(const TetMesh& mesh, const Surface& surface) {
  Skin skin{.mesh = mesh};
  for (const Triangle& corners : surface.triangles) {
    const Vec3 a = mesh.nodes[corners[0]], b = mesh.nodes[corners[1]], c = mesh.nodes[corners[2]];
    const Vec3 outward = (b - a).cross(c - a);
    for (const int node : corners) {
      skin.area[node] += outward.norm() / 6.0;
      skin.outward.try_emplace(node, Vec3(Vec3::Zero())).first->second += outward;
      std::vector<int>& beside = skin.neighbours[node];
      beside.insert(beside.end(), corners.begin(), corners.end());
    }
  }
  return skin;
}

std::set<int> connected(const Skin& skin, int middle, const std::function<bool(int)>& within) {
  std::set<int> found{middle};
  std::vector<int> next{middle};
  while (!next.empty()) {
    const int from = next.back();
    next.pop_back();
    for (const int node : skin.neighbours.at(from))
      if (within(node) && found.insert(node).second) next.push_back(node);
  }
  return found;
}

double across(const ProbeSpec& spec, const TetMesh& mesh, int middle, int node) {
  return (mesh.nodes[node] - mesh.nodes[middle]).cross(spec.direction).norm();
}

void refuse_smaller_than_mesh(const ProbeSpec& spec, const Skin& skin, int middle) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const int node : skin.neighbours.at(middle))
    if (node != middle) nearest = std::min(nearest, (skin.mesh.nodes[node] - skin.mesh.nodes[middle]).norm());
  if (spec.radius > nearest) return;
  refuse_key(fmt::format("probes.{}.radius", spec.name),
             fmt::format(
                 "a {} of {:.3g} mm is smaller than the mesh of {} there, whose next node is {:.3g} mm away; "
                 "accepted: more than that (twice as much for a force that does not hang on the mesh), or "
                 "kind = \"point\"",
                 spec.kind, 1e3 * spec.radius, spec.body, 1e3 * nearest));
}

}  // namespace palpate::sim
