#include "sim/cycle/press.hpp"

#include <fmt/format.h>

#include <cassert>
#include <chrono>
#include <stdexcept>

#include "sim/pairing/overlaps.hpp"

namespace palpate::sim {
namespace {

std::vector<double> remaining_overlaps(const Model& model, const Simulation& simulation) {
  return deepest_overlaps(model, simulation.motion());
}

}  // namespace

std::vector<ProbeDisplacement> displaced_by(const Model& model, double depth) {
  std::vector<ProbeDisplacement> displacements;
  for (const Probe& probe : model.probes) displacements.push_back({depth * probe.direction});
  return displacements;
}

double normal_force(const Probe& probe, const Vec3& force_on_finger) {
  return -force_on_finger.dot(probe.direction);
}

void require_solved(const Press& press) {
  for (const PressStep& step : press.curve)
    if (!solved(step.solve.stop))
      throw std::runtime_error(fmt::format("the displacements could not be solved at a depth of {:g} mm ({})",
                                           1e3 * step.depth, to_string(step.solve.stop)));
}

PressStep press_step(const Model& model, Simulation& simulation, ProbeDisplacements probes, double dt) {
  PressStep step{.depth = probes.front().from_rest.dot(model.probes.front().direction),
                 .probes = {probes.begin(), probes.end()}};
  const auto before = std::chrono::steady_clock::now();
  const CycleResult result = simulation.step(probes, dt);
  const std::chrono::duration<double, std::micro> taken = std::chrono::steady_clock::now() - before;
  step.cycle_us = taken.count();
  step.probe_forces.assign(result.probe_forces.begin(), result.probe_forces.end());
  step.probe_torques.assign(result.probe_torques.begin(), result.probe_torques.end());
  step.pairs.assign(result.pairs.begin(), result.pairs.end());
  step.pairs.resize(model.pairs.size());  // without a law that has anything to do, bodies do nothing
  step.penetration = remaining_overlaps(model, simulation);
  step.solve = result.solve;
  return step;
}

Press press(const Model& model, double depth, int steps) {
  assert(steps > 0);
  Simulation simulation(model);
  Press press;
  for (int i = 1; i <= steps; ++i) {
    const double here = depth * i / steps;
    press.curve.push_back(press_step(model, simulation, displaced_by(model, here), kCyclePeriod));
    press.curve.back().depth = here;  // as it was asked for, to the last bit
  }
  press.loads = simulation.loads();
  return press;
}

}  // namespace palpate::sim
