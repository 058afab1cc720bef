#include "sim/probe/probes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/probe/kinds.hpp"
#include "sim/scene/refuse_key.hpp"

namespace palpate::sim {
namespace {

[[noreturn]] void refuse(const ProbeSpec& spec, const std::string& what) {
  refuse_key(fmt::format("probes.{}", spec.name), what);
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

}  // namespace

void prescribe(const Model& model, ProbeDisplacements displacements, ProbeRows& rows) {
  for (std::size_t i = 0; i < model.probes.size(); ++i)
    model.probes[i].kind->prescribe(model.probes[i], displacements[i], rows[i]);
}

void place_probe(const ProbeSpec& spec, const TetMesh& mesh, const Surface& surface,
                 const std::vector<int>& fixed, Probe& probe) {
  const auto* tag = std::get_if<std::int64_t>(&spec.at);
  const int middle = tag ? node_of_tag(spec, mesh, *tag)
                         : nearest_surface_node(spec, mesh, surface, std::get<Vec3>(spec.at));
  if (!std::ranges::binary_search(surface.nodes, middle))
    refuse(spec, fmt::format("node {} lies inside {}; accepted: a node of its surface", *tag, spec.body));
  probe.kind = &probe_kind(spec.kind);
  probe.kind->hold(spec, mesh, surface, middle, probe);
  probe.at.setZero();
  for (std::size_t i = 0; i < probe.nodes.size(); ++i) {
    const int node = probe.nodes[i];
    if (std::ranges::binary_search(fixed, node))
      refuse(spec, fmt::format("it would hold node {} of {}, which is fixed; move it away from the supports",
                               mesh.node_tags[node], spec.body));
    probe.at += probe.weights[i] * mesh.nodes[node];
  }
}

}  // namespace palpate::sim
