// 16, 17, 19, 22: what is computed from the stiffness.
#include <Eigen/Cholesky>
#include <algorithm>
#include <numeric>

#include "sim/contact/exact/exact.hpp"
#include "sim/elasticity/static_solve.hpp"
#include "tests/hard_cases/refusal.hpp"
#include "tests/hard_cases/residual.hpp"
#include "tests/hard_cases/runs.hpp"
#include "tests/hard_cases/scenes.hpp"
#include "tests/sim/support/box_mesh.hpp"
#include "tests/sim/support/on_mesh.hpp"

namespace palpate::hard_cases {
namespace {

/// What the supports of a body carry, by its stiffness, and the loads on it: their sum is an error.
double unbalanced(const sim::Body& body, const Eigen::Matrix3Xd& u, const Eigen::Matrix3Xd& f) {
  const Eigen::Matrix3Xd taken =
      (sim::stiffness(*body.mesh, body.materials) * u.reshaped()).reshaped(3, u.cols());
  const Vec3 support = taken(Eigen::all, body.fixed).rowwise().sum(), total = f.rowwise().sum();
  return (support + total).norm() / total.norm();
}

/// Largest error of a nodal force, by the stiffness, relative to the largest force.
double nodal_error(const sim::Body& body, const Eigen::Matrix3Xd& u, const Eigen::Matrix3Xd& f) {
  Eigen::Matrix3Xd residual =
      (sim::stiffness(*body.mesh, body.materials) * u.reshaped()).reshaped(3, u.cols()) - f;
  residual(Eigen::all, body.fixed).setZero();
  return residual.cwiseAbs().maxCoeff() / f.cwiseAbs().maxCoeff();
}

}  // namespace

Outcome stiffness_ratio(Jitter& jitter) {
  SceneOf scene = two_boxes(jitter);
  Outcome outcome{.limit = 1e-6};
  for (const double ratio : {1e6, 1e-6}) {
    scene.bodies[1].modulus = ratio * scene.bodies[0].modulus;
    const sim::Model model = compiled(scene, "exact");
    sim::Simulation simulation(model);
    for (const Vec3& there : {Vec3(0, 0, -0.7e-3), Vec3(0.4e-3, -0.3e-3, -2e-3), Vec3(0, 0.2e-3, -3e-3)}) {
      const sim::CycleResult result = step_to(simulation, there);
      outcome.expect(result.solve.stop == sim::Stop::Converged, "it stalls");
      outcome.expect(result.pairs[0].active > 0, "nothing touches");
      const auto u = solved_with_stiffness(model, simulation.loads());
      for (std::size_t i = 0; i < 2; ++i) {
        const Eigen::Matrix3Xd f = sim::test::on_mesh(model.bodies[i], simulation.loads().on_body[i]);
        outcome.figure = std::max(outcome.figure, unbalanced(model.bodies[i], u[i], f));
        outcome.expect(nodal_error(model.bodies[i], u[i], f) <= 1e-4, "nodal forces differ");
      }
      outcome.expect(residual_from_stiffness(model, simulation) <= 1e-4, "contact is not solved, by K");
    }
  }
  return outcome;
}

Outcome compliance_spd(Jitter& jitter) {
  Outcome outcome{.limit = 1e-12};
  const TetMesh mesh =
      jitter.of(sim::test::shaken(sim::test::box_mesh(5, 4, 4, Vec3(0.05, 0.04, 0.04)), 0.9e-3, 11), 0.01);
  const sim::Material tissue{.young_modulus = jitter.of(1.0), .poisson_ratio = jitter.of(0.45)};
  const std::vector<int> touch = mesh.node_groups.at("z_max");
  const Eigen::MatrixXd C =
      sim::condense(sim::stiffness(mesh, {&tissue, 1}), mesh.node_groups.at("z_min"), touch, {}).touch_touch;
  outcome.figure = (C - C.transpose()).cwiseAbs().maxCoeff() / C.cwiseAbs().maxCoeff();
  outcome.expect(C.llt().info() == Eigen::Success, "it is not positive definite");
  return outcome;
}

Outcome single_precision(Jitter& jitter) {
  const sim::Model full = compiled(two_boxes(jitter), "exact");
  sim::Model rounded = full;
  rounded.contact_precision = sim::Precision::Single;
  sim::Simulation exact(full), single(rounded);
  Outcome outcome{.limit = 1.0};
  const auto closed = [](const sim::Simulation& simulation) {
    const std::span<const int> rows =
        static_cast<const sim::ExactScratch&>(*simulation.law_scratch()).solve.active();
    std::vector<int> sorted(rows.begin(), rows.end());
    std::ranges::sort(sorted);
    return sorted;
  };
  for (int step = 1; step <= 40; ++step) {
    const Vec3 there = jitter.of(Vec3(0.2e-3, -0.1e-3, -75e-6 * step));
    const sim::CycleResult right = step_to(exact, there), felt = step_to(single, there);
    const double error = (felt.probe_forces[0] - right.probe_forces[0]).norm();
    const double bound = felt.solve.force_error_bound + right.solve.force_error_bound;
    if (error > 0.0) outcome.figure = std::max(outcome.figure, error / bound);
    outcome.expect(error <= 1e-6 * right.probe_forces[0].norm(), "the force differs by more than 1e-6");
    outcome.expect(closed(exact) == closed(single), "other contacts are closed");
  }
  return outcome;
}

Outcome big_sizes(Jitter& jitter) {
  Outcome outcome;
  const auto touched = static_cast<int>(jitter.of(1e6));  // 9e12 entries
  std::vector<int> touch(static_cast<std::size_t>(touched));
  std::iota(touch.begin(), touch.end(), 0);
  const std::string refusal =
      refused([&] { sim::condense(Eigen::SparseMatrix<double>(3 * touched, 3 * touched), {}, touch, {}); });
  outcome.expect(says(refusal, "GB, more than half of"), "refusal: " + refusal);
  // A body of more touchable nodes than a scene may have (its compliance would have 2^31 entries from 15 448 on).
  SceneOf scene;
  scene.bodies = {
      {.name = "upper", .mesh = jitter.of(sim::test::box_mesh(34, 34, 1, Vec3(34e-3, 34e-3, 1e-3)), 1e-4)}};
  scene.probes = {{.kind = "kind = \"point\"", .at = Vec3(17e-3, 17e-3, 1e-3)}};
  outcome.expect(says(refusal_of(write_scene(scene), {}), "bodies.upper.touchable"),
                 "too many nodes are taken");
  return outcome;
}

}  // namespace palpate::hard_cases
