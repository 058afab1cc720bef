#include "sim/cycle/free_deformation.hpp"

#include <algorithm>

namespace palpate::sim {

SolveReport free_deformation(const Model& model, std::span<PrescribedSolve> solves, FreeState& free,
                             Response& response) {
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    BodyMotion& motion = free.motion[i];
    PrescribedSolve& solve = solves[i];
    const bool was_moved = motion.moved;
    motion.moved = std::ranges::any_of(model.bodies[i].probes, [&](int probe) {
      return free.probes[probe].pressing || !free.probes[probe].region.isZero(0.0);
    });
    if (!motion.moved) {  // it is where it rests, whatever the cycle before has left
      if (was_moved) motion.displacement.setZero();
      continue;
    }
    motion.displacement.setZero();
    for (const int probe : model.bodies[i].probes)
      if (const auto& region = model.probes[probe].region)
        motion.displacement.noalias() += region->touch_motion * free.probes[probe].region;
    if (!solve.factor(free.probes, {})) return {.stop = Stop::SingularMatrix};
    solve.solve(&free.probes, {});
    solve.add_displacement(motion.displacement);
    solve.add_forces(response.loads.on_body[i]);
    for (const int probe : model.bodies[i].probes) response.probe_forces[probe] = solve.probe_force(probe);
  }
  return {};
}

}  // namespace palpate::sim
