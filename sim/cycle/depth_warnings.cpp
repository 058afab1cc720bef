#include "sim/cycle/depth_warnings.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "sim/surface/ray.hpp"

namespace palpate::sim {

FarSide far_side(const Model& model, const Probe& probe) {
  const Body& body = model.bodies[probe.body];
  const auto at = [&](int node) -> const Vec3& { return body.mesh->nodes[node]; };
  double extent = 0.0;
  for (const Vec3& node : body.mesh->nodes) extent = std::max(extent, (node - probe.at).norm());
  FarSide nearest{.distance = std::numeric_limits<double>::infinity()};
  for (const Triangle& triangle : body.surface->triangles) {
    const auto& [a, b, c] = triangle;
    const Vec3 outwards = (at(b) - at(a)).cross(at(c) - at(a));
    const double distance = distance_to_triangle(probe.at, probe.direction, at(a), at(b), at(c));
    // Where the line leaves the body: not where a pad in a hollow, or round-off, lets it enter first.
    if (outwards.dot(probe.direction) > 0 && distance > 1e-6 * extent && distance < nearest.distance)
      nearest = {distance, triangle};
  }
  return nearest;
}

namespace {

/// How far the far side has come along the press [m].
double given_way(const Model& model, const Probe& probe, const FarSide& far, const Loads& loads) {
  const std::vector<int>& drawn = model.bodies[probe.body].compliance->drawn;
  const Eigen::VectorXf u = deform(model, probe.body, loads);
  double sum = 0.0;
  for (const int node : far.triangle) {
    const auto entry = std::ranges::lower_bound(drawn, node) - drawn.begin();
    if (entry < std::ssize(drawn) && drawn[entry] == node)  // else it is fixed
      sum += u.segment<3>(3 * entry).cast<double>().dot(probe.direction);
  }
  return sum / 3;
}

}  // namespace

std::string depth_warning(const Model& model, const Probe& probe, double depth, const Loads& loads) {
  std::string deeper;
  if (depth > probe.depth * (1 + 1e-9))
    deeper = fmt::format("than the {:.6g} mm of the scene", 1e3 * probe.depth);
  const FarSide far =
      probe.region ? FarSide{.distance = std::numeric_limits<double>::infinity()} : far_side(model, probe);
  if (depth > far.distance && depth > far.distance + given_way(model, probe, far, loads))
    deeper += fmt::format("{}than {} is thick under it ({:.3g} mm)", deeper.empty() ? "" : ", and ",
                          model.bodies[probe.body].name, 1e3 * far.distance);
  if (deeper.empty()) return {};
  return fmt::format("probes.{} presses {:.6g} mm deep, deeper {}", probe.name, 1e3 * depth, deeper);
}

std::vector<std::string> depth_warnings(const Model& model, double depth, const Loads& loads) {
  std::vector<std::string> warnings;
  for (const Probe& probe : model.probes)
    if (std::string warning = depth_warning(model, probe, depth, loads); !warning.empty())
      warnings.push_back(std::move(warning));
  return warnings;
}

}  // namespace palpate::sim
