#include "app/commands/check/body_warnings.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "analysis/words/words.hpp"
#include "sim/model/probe_kind.hpp"

namespace palpate::app {
namespace {

constexpr double kLocking = 0.45;     // Poisson's ratio from which on locking shows
constexpr std::size_t kPadNodes = 3;  // fewer are no area

/// Extent of a body along its diagonal [m].
double size_of(const sim::Body& body) {
  sim::Vec3 lower = body.mesh->nodes.front(), upper = lower;
  for (const sim::Vec3& node : body.mesh->nodes) {
    lower = lower.cwiseMin(node);
    upper = upper.cwiseMax(node);
  }
  return (upper - lower).norm();
}

/// Unit normal, out of the body, of the surface that a probe holds: the mean over its polygons, by their area.
sim::Vec3 normal_at(const sim::Body& body, const sim::Probe& probe) {
  sim::Vec3 sum = sim::Vec3::Zero();
  for (const int touch : probe.nodes) {
    const int held = body.compliance->touch[touch];
    for (const sim::Triangle& corners : body.surface->triangles) {
      if (std::ranges::find(corners, held) == corners.end()) continue;
      const sim::Vec3 a = body.mesh->nodes[corners[0]];
      sum += (body.mesh->nodes[corners[1]] - a).cross(body.mesh->nodes[corners[2]] - a);
    }
  }
  return sum.normalized();
}

void add_probe_warnings(const sim::Body& body, const sim::Probe& probe, std::vector<std::string>& warnings) {
  if (!probe.nodes.empty() && normal_at(body, probe).dot(probe.direction) > 0.0)
    warnings.push_back(fmt::format(
        "probes.{} pulls outwards: its direction points out of {}; accepted without warning: a direction into it",
        probe.name, body.name));
  if (const double size = size_of(body); probe.depth > size)
    warnings.push_back(fmt::format("probes.{} presses {:g} mm deep into a body {:g} mm across", probe.name,
                                   1e3 * probe.depth, 1e3 * size));
  if (probe.kind->keys.takes_radius && !probe.tip && probe.nodes.size() < kPadNodes)
    warnings.push_back(
        fmt::format("probes.{}: its radius reaches no more than {} of the mesh, so that the {} acts as a "
                    "point; accepted without warning: a radius of two edges or more",
                    probe.name, analysis::counted(static_cast<long>(probe.nodes.size()), "node", "nodes"),
                    probe.kind->keys.name));
}

}  // namespace

std::vector<std::string> body_warnings(const sim::Model& model, const sim::Body& body) {
  std::vector<std::string> warnings;
  const auto locking = std::ranges::find_if(
      body.materials, [](const sim::Material& material) { return material.poisson_ratio >= kLocking; });
  if (locking != body.materials.end())
    warnings.push_back(fmt::format(
        "poisson_ratio {}: linear tetrahedra lock as it nears 0.5, and forces come out too large; this "
        "version has no treatment of near-incompressibility",
        locking->poisson_ratio));
  for (const int probe : body.probes) add_probe_warnings(body, model.probes[probe], warnings);
  return warnings;
}

}  // namespace palpate::app
