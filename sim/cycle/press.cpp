#include "sim/cycle/press.hpp"

#include <fmt/format.h>

#include <cassert>
#include <chrono>
#include <stdexcept>

#include "sim/pairing/find_pairs.hpp"

namespace palpate::sim {
namespace {

std::vector<double> remaining_overlaps(const Model& model, const Scratch& scratch) {
  FreeMotion motion = rest_motion(model);
  for (std::size_t i = 0; i < motion.size(); ++i) {
    motion[i].displacement = scratch.displacement(static_cast<int>(i));
    motion[i].moved = true;
  }
  place(model, motion);
  return deepest_overlaps(model, motion);
}

}  // namespace

std::vector<ProbePose> pose_at_depth(const Model& model, double depth) {
  std::vector<ProbePose> pose;
  for (const Probe& probe : model.probes) pose.push_back({depth * probe.direction});
  return pose;
}

double normal_force(const Probe& probe, const Vec3& force_on_finger) {
  return -force_on_finger.dot(probe.direction);
}

void require_solved(const Press& press) {
  for (const PressStep& step : press.curve)
    if (step.solve.stop != Stop::Converged)
      throw std::runtime_error(fmt::format("the displacements could not be solved at a depth of {:g} mm ({})",
                                           1e3 * step.depth, to_string(step.solve.stop)));
}

Press press(const Model& model, double depth, int steps) {
  assert(steps > 0);
  Scratch scratch(model);
  Press press;
  for (int i = 1; i <= steps; ++i) {
    PressStep step{.depth = depth * i / steps};
    const std::vector<ProbePose> pose = pose_at_depth(model, step.depth);
    const auto before = std::chrono::steady_clock::now();
    const CycleResult result = cycle(model, {}, pose, scratch);
    const std::chrono::duration<double, std::micro> taken = std::chrono::steady_clock::now() - before;
    step.cycle_us = taken.count();
    step.probe_forces.assign(result.probe_forces.begin(), result.probe_forces.end());
    step.pairs.assign(result.pairs.begin(), result.pairs.end());
    step.penetration = remaining_overlaps(model, scratch);
    step.solve = result.solve;
    press.curve.push_back(std::move(step));
  }
  press.loads = scratch.loads();
  return press;
}

}  // namespace palpate::sim
