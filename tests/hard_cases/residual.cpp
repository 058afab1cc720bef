#include "tests/hard_cases/residual.hpp"

#include <algorithm>
#include <cmath>

#include "sim/contact/exact/exact.hpp"
#include "sim/elasticity/static_solve.hpp"
#include "tests/sim/support/on_mesh.hpp"

namespace palpate::hard_cases {

std::vector<Eigen::Matrix3Xd> solved_with_stiffness(const sim::Model& model, const sim::Loads& loads) {
  std::vector<Eigen::Matrix3Xd> displacements;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const sim::Body& body = model.bodies[i];
    displacements.push_back(sim::static_solve(sim::stiffness(*body.mesh, body.materials), body.fixed,
                                              sim::test::on_mesh(body, loads.on_body[i])));
  }
  return displacements;
}

double residual_from_stiffness(const sim::Model& model, const sim::Simulation& simulation) {
  const auto& scratch = static_cast<const sim::ExactScratch&>(*simulation.law_scratch());
  const auto u = solved_with_stiffness(model, simulation.loads());
  const auto at = [&](int body, int touch) -> sim::Vec3 {
    return u[static_cast<std::size_t>(body)].col(model.bodies[body].compliance->touch[touch]);
  };
  double error = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < scratch.pairs.size(); ++i) {
    const sim::FacingPair& pair = scratch.pairs[i];
    sim::Vec3 away = at(pair.node_body, pair.node);
    for (int k = 0; k < 3; ++k) away -= pair.weights[k] * at(pair.polygon_body, pair.corners[k]);
    const Eigen::Index row = scratch.system.bilateral + static_cast<Eigen::Index>(i);
    const double force = scratch.solve.forces()[row];
    const double slack = (pair.gap + pair.normal.dot(away)) / scratch.system.compliance(row, row);
    error = std::max(error, std::abs(force - std::max(0.0, force - slack)));
    largest = std::max(largest, force);
  }
  return error / largest;
}

}  // namespace palpate::hard_cases
