#include "sim/probe/probes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/probe/kinds.hpp"
#include "sim/scene/refuse_key.hpp"

namespace palpate::sim {
namespace {

constexpr double kNearSurface = 0.5;  // of a body's size: farther from every node is no place at its surface

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
  if (!(std::sqrt(least) <= kNearSurface * size))
    refuse(
        spec,
        fmt::format(
            "at: is {:g} m away from the surface of {}, which is {:g} m across; accepted: a place at its surface",
            (nearest < 0 ? Vec3(0.5 * (lower + upper) - place) : Vec3(mesh.nodes[nearest] - place))
                .stableNorm(),
            spec.body, size));
  return nearest;
}

}  // namespace

bool any_slides(const Model& model) {
  return std::ranges::any_of(model.probes, [](const Probe& probe) { return !probe.slide.knots.empty(); });
}

ProbeRows probe_rows(const Model& model) {
  ProbeRows rows(model.probes.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (model.probes[i].slide.knots.empty()) continue;
    const Knot& knot = model.probes[i].slide.knots.front();
    rows[i].weights = knot.weights;
    rows[i].compliance = knot.compliance;
  }
  return rows;
}

namespace {

/// What a region brings the other probes of its body is not left for their forces to do.
void take_away(const Model& model, std::size_t holding, ProbeRows& rows) {
  const Region& region = *model.probes[holding].region;
  for (const int other : model.bodies[model.probes[holding].body].probes) {
    const Probe& probe = model.probes[other];
    const std::span<const double> weights = weights_of(probe, rows[other]);
    for (std::size_t i = 0; i < probe.nodes.size(); ++i) {
      const Vec3 brought = region.touch_motion.middleRows<3>(3 * probe.nodes[i]) * rows[holding].region;
      for (Eigen::Index k = 0; k < probe.axes.cols(); ++k)
        rows[other].value[k] -= weights[i] * probe.axes.col(k).dot(brought);
    }
  }
}

/// What is displaced by less counts as not displaced [m, rad]: products of what it would bring are denormal numbers
/// (below 2.2e-308), with which processors are slow, or 0, with which no sign is right any more.
constexpr double kLeastDisplacement = 1e-100;

Vec3 without_the_smallest(const Vec3& displacement) {
  return (displacement.array().abs() < kLeastDisplacement).select(0.0, displacement);
}

}  // namespace

void prescribe(const Model& model, ProbeDisplacements displacements, ProbeRows& rows) {
  for (std::size_t i = 0; i < model.probes.size(); ++i)
    model.probes[i].kind->prescribe(model.probes[i],
                                    {.from_rest = without_the_smallest(displacements[i].from_rest),
                                     .rotation = without_the_smallest(displacements[i].rotation)},
                                    rows[i]);
  for (std::size_t i = 0; i < model.probes.size(); ++i)
    if (model.probes[i].region) take_away(model, i, rows);
}

namespace {

void hold_group(const ProbeSpec& spec, const TetMesh& mesh, const std::vector<int>& fixed, Probe& probe) {
  const auto found = mesh.node_groups.find(spec.group);
  if (found == mesh.node_groups.end() || found->second.empty()) {
    std::vector<std::string_view> names;
    for (const auto& [name, nodes] : mesh.node_groups) names.push_back(name);
    refuse_key(
        fmt::format("probes.{}.group", spec.name),
        fmt::format("the mesh of {} has no group \"{}\" with nodes; accepted: {}", spec.body, spec.group,
                    names.empty() ? "a mesh with named groups" : fmt::format("{}", fmt::join(names, ", "))));
  }
  Region region{.nodes = found->second};
  std::ranges::sort(region.nodes);
  probe.at.setZero();
  for (const int node : region.nodes) {
    if (std::ranges::binary_search(fixed, node))
      refuse(spec,
             fmt::format(
                 "it would hold node {} of {}, which is fixed; accepted: a group apart from the supports",
                 mesh.node_tags[node], spec.body));
    probe.at += mesh.nodes[node] / static_cast<double>(region.nodes.size());
  }
  probe.region = std::make_shared<const Region>(std::move(region));
}

}  // namespace

namespace {

/// What is fixed gives way to no finger.
void meet_free_nodes(const std::vector<int>& fixed, const Vec3& place, Probe& probe) {
  Fingertip tip = *probe.tip;
  std::erase_if(tip.nodes, [&](int node) { return std::ranges::binary_search(fixed, node); });
  probe.tip = std::make_shared<const Fingertip>(std::move(tip));
  probe.at = place;
}

}  // namespace

void place_probe(const ProbeSpec& spec, const TetMesh& mesh, const Surface& surface,
                 const std::vector<int>& fixed, Probe& probe) {
  probe.kind = &probe_kind(spec.kind);
  if (probe.kind->keys.takes_group) return hold_group(spec, mesh, fixed, probe);
  const auto* tag = std::get_if<std::int64_t>(&spec.at);
  const int middle = tag ? node_of_tag(spec, mesh, *tag)
                         : nearest_surface_node(spec, mesh, surface, std::get<Vec3>(spec.at));
  if (!std::ranges::binary_search(surface.nodes, middle))
    refuse(spec, fmt::format("node {} lies inside {}; accepted: a node of its surface", *tag, spec.body));
  probe.kind->hold(spec, mesh, surface, middle, probe);
  if (probe.tip) return meet_free_nodes(fixed, mesh.nodes[middle], probe);
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
