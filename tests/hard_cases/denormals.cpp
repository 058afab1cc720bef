// 20: displacements so small that products of them are denormal numbers.
#include <algorithm>
#include <chrono>
#include <cmath>

#include "tests/hard_cases/runs.hpp"
#include "tests/hard_cases/scenes.hpp"

namespace palpate::hard_cases {
namespace {

/// p99 of the cycle's time in a press of 200 steps to `depth`, the least of several presses: what else the machine did
/// meanwhile is in the others [us].
double p99_of_press(const sim::Model& model, double depth) {
  double least = INFINITY;
  for (int press = 0; press < 12; ++press) {
    sim::Simulation simulation(model);
    std::vector<double> times;
    for (int step = 1; step <= 200; ++step) {
      const auto begun = std::chrono::steady_clock::now();
      step_to(simulation, Vec3(0, 0, -depth * step / 200));
      times.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begun).count());
    }
    std::ranges::nth_element(times, times.begin() + 197);
    least = std::min(least, times[197]);
  }
  return least;
}

}  // namespace

Outcome denormals(Jitter& jitter) {
  // Bodies that touch, so that a press of any depth is one of contact.
  const auto scene = write_scene(two_boxes(jitter, {.gap = 0.0}));
  return of_all_laws(2.0, [&](std::string_view law, Outcome&) {
    const sim::Model model = compiled(scene, law);
    return p99_of_press(model, 1e-310) / p99_of_press(model, 1e-3);
  });
}

}  // namespace palpate::hard_cases
