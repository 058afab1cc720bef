#include "sim/cost/press_accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/cycle/press.hpp"
#include "sim/surface/aabb_tree.hpp"
#include "sim/surface/barycentric.hpp"

namespace palpate::sim {
namespace {

double imbalance_of(const PressStep& step) {
  double most = 0.0;
  for (const PairSummary& pair : step.pairs) {
    const double larger = std::max(pair.force_on[0].norm(), pair.force_on[1].norm());
    if (larger > 0.0) most = std::max(most, (pair.force_on[0] + pair.force_on[1]).norm() / larger);
  }
  return most;
}

void take_curve(const Model& model, const PressPlan& plan, PressAccuracy& accuracy) {
  Simulation simulation(model);
  for (int i = 1; i <= plan.steps; ++i) {
    const PressStep step =
        press_step(model, simulation, displaced_by(model, plan.depth * i / plan.steps), kCyclePeriod);
    accuracy.unsolved += solved(step.solve.stop) ? 0 : 1;
    accuracy.forces.push_back(normal_force(model.probes.front(), step.probe_forces.front()));
    for (const double overlap : step.penetration)
      accuracy.penetration = std::max(accuracy.penetration, overlap);
    accuracy.imbalance = std::max(accuracy.imbalance, imbalance_of(step));
    accuracy.force_error_bound = std::max(accuracy.force_error_bound, step.solve.force_error_bound);
  }
  for (int body = 0; body < std::ssize(model.bodies); ++body)
    accuracy.displacement.push_back(simulation.displacement(body));
}

void look_for_jumps(const Model& model, const PressPlan& plan, PressAccuracy& accuracy) {
  Simulation simulation(model);
  const auto poses = static_cast<int>(std::lround(plan.depth / plan.small_step));
  double before = 0.0;
  for (int i = 1; i <= poses; ++i) {
    const CycleResult result = simulation.step(displaced_by(model, i * plan.small_step), kCyclePeriod);
    accuracy.unsolved += solved(result.solve.stop) ? 0 : 1;
    const double here = normal_force(model.probes.front(), result.probe_forces.front());
    accuracy.largest_jump = std::max(accuracy.largest_jump, std::abs(here - before));
    before = here;
  }
}

/// Of the place of a body's surface that is nearest to another place at rest.
Vec3 displacement_at(const Body& body, const Eigen::VectorXd& displacement, const Vec3& place) {
  const NearestPolygon found = find_nearest(body.tree, body.polygons.triangles, body.rest, place,
                                            std::numeric_limits<double>::infinity());
  if (found.polygon < 0) return Vec3::Zero();
  const Triangle& corners = body.polygons.triangles[found.polygon];
  const Vec3 weights = barycentric(found.nearest.point, body.rest.col(corners[0]), body.rest.col(corners[1]),
                                   body.rest.col(corners[2]));
  Vec3 mean = Vec3::Zero();
  for (int k = 0; k < 3; ++k) mean += weights[k] * displacement.segment<3>(3 * corners[k]);
  return mean;
}

}  // namespace

PressAccuracy measure_accuracy(const Model& model, const PressPlan& plan) {
  PressAccuracy accuracy;
  take_curve(model, plan, accuracy);
  look_for_jumps(model, plan, accuracy);
  return accuracy;
}

double edge_of(const Model& model) {
  double area = 0.0;
  std::size_t count = 0;
  for (const Body& body : model.bodies)
    for (const auto& [a, b, c] : body.polygons.triangles) {
      area +=
          0.5 *
          Vec3(body.rest.col(b) - body.rest.col(a)).cross(Vec3(body.rest.col(c) - body.rest.col(a))).norm();
      ++count;
    }
  return count == 0 ? 0.0 : std::sqrt(area / static_cast<double>(count));
}

double displacement_error(const Model& model, const std::vector<Eigen::VectorXd>& displacement,
                          const Model& finer, const std::vector<Eigen::VectorXd>& finer_displacement) {
  double difference = 0.0, whole = 0.0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    for (const int node : model.bodies[b].colliding_nodes) {
      const Vec3 there =
          displacement_at(finer.bodies[b], finer_displacement[b], model.bodies[b].rest.col(node));
      difference += (displacement[b].segment<3>(3 * node) - there).squaredNorm();
      whole += there.squaredNorm();
    }
  return whole > 0.0 ? std::sqrt(difference / whole) : 0.0;
}

}  // namespace palpate::sim
