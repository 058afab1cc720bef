#include "sim/cycle/stroke.hpp"

#include <fmt/format.h>

#include <cassert>
#include <stdexcept>

namespace palpate::sim {

Stroke stroke(const Model& model, std::span<const StrokePose> poses) {
  assert(!poses.empty());
  Simulation simulation(model);
  Stroke stroke;
  for (const StrokePose& pose : poses) {
    const double dt = stroke.times.empty() ? kCyclePeriod : pose.time - stroke.times.back();
    stroke.times.push_back(pose.time);
    stroke.steps.push_back(press_step(model, simulation, pose.probes, dt));
  }
  stroke.loads = simulation.loads();
  return stroke;
}

void require_solved(const Stroke& stroke) {
  for (std::size_t i = 0; i < stroke.steps.size(); ++i)
    if (const Stop stop = stroke.steps[i].solve.stop; !solved(stop))
      throw std::runtime_error(fmt::format("the displacements could not be solved at a time of {:g} s ({})",
                                           stroke.times[i], to_string(stop)));
}

}  // namespace palpate::sim
