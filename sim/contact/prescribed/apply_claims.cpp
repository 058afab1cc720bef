#include <algorithm>

#include "sim/contact/prescribed/prescribed_law.hpp"

namespace palpate::sim {
namespace {

/// Contact force on the nodes of one body, booked with the pair of bodies that asked for the displacement.
/// @param multipliers  of the asked nodes, x y z of each, for E = 1 Pa
void book_contact_forces(const Model& model, int body, std::span<const double> multipliers,
                         PrescribedScratch& scratch) {
  const Claims& claims = scratch.bodies[body].claims;
  const double young_modulus = model.bodies[body].young_modulus;
  const double* force = multipliers.data();
  for (const int node : claims.nodes) {
    const int pair = claims.touch_pair[node];
    const int side = model.pairs[pair].bodies[0] == body ? 0 : 1;
    scratch.summaries[pair].force_on[side] += young_modulus * Vec3(force[0], force[1], force[2]);
    force += 3;
  }
}

/// Largest error of what was asked, relative to the largest displacement asked.
double residual(const Claims& claims, PrescribedSolve& solve) {
  double largest = 0.0, error = 0.0;
  const double* brought = solve.brought().data() + solve.probe_rows();
  for (std::size_t i = 0; i < claims.nodes.size(); ++i, brought += 3) {
    const Vec3& asked = claims.displacement[claims.nodes[i]];
    largest = std::max(largest, asked.norm());
    error = std::max(error, (Vec3(brought[0], brought[1], brought[2]) - asked).norm());
  }
  return largest > 0.0 ? error / largest : 0.0;
}

}  // namespace

SolveReport apply_claims(const Model& model, const FreeState& free, PrescribedScratch& scratch,
                         Response& response) {
  SolveReport report{.iterations = 1};
  for (int i = 0; i < std::ssize(model.bodies); ++i) {
    auto& [solve, claims] = scratch.bodies[i];
    claims.sort();
    if (claims.nodes.empty()) continue;
    if (!solve.factor(free.probes, claims.nodes)) return {.stop = Stop::SingularMatrix};
    const auto multipliers = solve.solve(nullptr, claims.displacement);
    solve.add_forces(response.loads.on_body[i]);
    for (const int probe : model.bodies[i].probes) response.probe_forces[probe] += solve.probe_force(probe);
    book_contact_forces(model, i, multipliers.subspan(solve.probe_rows()), scratch);
    report.residual = std::max(report.residual, residual(claims, solve));
  }
  return report;
}

}  // namespace palpate::sim
