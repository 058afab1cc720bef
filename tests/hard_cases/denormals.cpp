// 20: displacements so small that products of them are denormal numbers.
#include <algorithm>
#include <chrono>
#include <cmath>

#include "tests/hard_cases/runs.hpp"
#include "tests/hard_cases/scenes.hpp"

namespace palpate::hard_cases {
namespace {

/// p99 of the cycle's time in a press of 100 steps to `depth`, the least of several presses: what else the machine did
/// meanwhile is in the others [us].
double p99_of_press(const sim::Model& model, double depth) {
  double least = INFINITY;
  for (int press = 0; press < 8; ++press) {
    sim::Simulation simulation(model);
    std::vector<double> times;
    for (int step = 1; step <= 100; ++step) {
      const auto begun = std::chrono::steady_clock::now();
      step_to(simulation, Vec3(0, 0, -depth * step / 100));
      times.push_back(
          std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begun).count());
    }
    std::ranges::nth_element(times, times.begin() + 98);
    least = std::min(least, times[98]);
  }
  return least;
}

}  // namespace

Outcome denormals(Jitter& jitter) {
  // Bodies that touch, so that a press of any depth is one of contact.
  const auto scene = write_scene(two_boxes(jitter, {.gap = 0.0}));
  return of_all_laws(2.0, [&](std::string_view law, Outcome&) {
    const sim::Model model = compiled(scene, law);
    const double usual = std::max(p99_of_press(model, 0.0), p99_of_press(model, 1e-3));
    double longest = 0.0;  // products of some are denormal, the last one is so itself
    for (const double depth : {1e-99, 1e-110, 1e-200, 1e-303, 1e-306, 1e-310})
      longest = std::max(longest, p99_of_press(model, depth));
    return longest / usual;
  });
}

}  // namespace palpate::hard_cases
