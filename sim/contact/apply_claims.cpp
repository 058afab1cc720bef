#include <algorithm>

#include "sim/contact/laws.hpp"

namespace palpate::sim {
namespace {

/// Contact force on the nodes of one body, booked with the pair of bodies that asked for the displacement.
void book_contact_forces(const Model& model, int body, std::span<const double> multipliers, int probe_rows,
                         Scratch::Buffers& buffers) {
  const Claims& claims = buffers.bodies[body].actual_claims;
  const double young_modulus = model.bodies[body].young_modulus;
  for (std::size_t i = 0; i < claims.nodes.size(); ++i) {
    const auto node = static_cast<std::size_t>(claims.nodes[i]);
    const double* force = multipliers.data() + static_cast<std::size_t>(probe_rows) + 3 * i;
    const auto pair = static_cast<std::size_t>(claims.touch_pair[node]);
    const auto side = static_cast<std::size_t>(model.pairs[pair].bodies[0] == body ? 0 : 1);
    buffers.summaries[pair].force_on[side] += young_modulus * Vec3(force[0], force[1], force[2]);
  }
}

/// Largest error of what was asked, relative to the largest displacement asked.
double residual(const Claims& claims, const Eigen::VectorXd& free, const Eigen::VectorXd& now) {
  double largest = 0.0, error = 0.0;
  for (const int node : claims.nodes) {
    const Vec3& asked = claims.displacement[node];
    largest = std::max(largest, asked.norm());
    error = std::max(error, (now.segment<3>(3 * node) - free.segment<3>(3 * node) - asked).norm());
  }
  return largest > 0.0 ? error / largest : 0.0;
}

}  // namespace

SolveReport apply_claims(const Model& model, Scratch::Buffers& buffers) {
  SolveReport report;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    BodyBuffers& body = buffers.bodies[i];
    body.actual_claims.sort();
    if (body.actual_claims.nodes.empty()) continue;
    if (!body.actual.factor(buffers.rows, body.actual_claims.nodes)) return {.stop = Stop::SingularMatrix};
    const auto multipliers = body.actual.solve(nullptr, body.actual_claims.displacement);
    body.actual.add_forces(buffers.loads.on_body[i]);
    body.actual.add_displacement(buffers.displacement[i]);
    for (const int probe : model.bodies[i].probes)
      buffers.probe_forces[probe] += body.actual.probe_force(probe);
    book_contact_forces(model, static_cast<int>(i), multipliers, body.actual.probe_rows(), buffers);
    report.residual =
        std::max(report.residual,
                 residual(body.actual_claims, buffers.free_motion[i].displacement, buffers.displacement[i]));
  }
  report.iterations = 1;
  return report;
}

}  // namespace palpate::sim
