// 31, 32, 45, 50, 52: the force follows the probe without jumps.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/hard_cases/runs.hpp"
#include "tests/hard_cases/scenes.hpp"
#include "tests/support/heap_use.hpp"

namespace palpate::hard_cases {
namespace {

constexpr double kMicrometre = 1e-6;
constexpr double kRounding = 1.0 + 1e-6;  // of the bound itself

/// A pad that presses the middle of the upper box.
SceneOf pressed_boxes(Jitter& jitter) {
  return two_boxes(jitter);
}

/// Largest change of force between neighbouring places of a way, less than `L` times their distance where it is below 1.
template <class Place>
double largest_jump(const sim::Model& model, double L, int steps, Place place) {
  sim::Simulation simulation(model);
  Vec3 before = place(0), force = step_to(simulation, before).probe_forces[0];
  double largest = 0.0;
  for (int step = 1; step <= steps; ++step) {
    const Vec3 here = place(step), now = step_to(simulation, here).probe_forces[0];
    largest = std::max(largest, (now - force).norm() / (L * (here - before).norm()));
    before = here;
    force = now;
  }
  return largest;
}

/// The same for every law along one way.
template <class Place>
Outcome jumps_along(const SceneOf& scene, int steps, Place place) {
  const auto file = write_scene(scene);
  const double L = steepest(compiled(file, "exact"));
  return of_each_law(kRounding, [&](std::string_view law, Outcome&) {
    return largest_jump(compiled(file, law), L, steps, place);
  });
}

}  // namespace

Outcome onset_of_contact(Jitter& jitter) {
  // From before the first contact to after the last one of a press of 2 mm.
  const Vec3 slant = jitter.of(Vec3(0.05, 0.02, -1.0));
  return jumps_along(pressed_boxes(jitter), 2000,
                     [&](int step) -> Vec3 { return step * kMicrometre * slant; });
}

Outcome sliding_across(Jitter& jitter) {
  // A circle of 2.5 mm: each node of the surface goes over edges and nodes of the other.
  const double depth = jitter.of(2e-3), radius = jitter.of(2.5e-3), turn = kMicrometre / radius;
  const int steps = jitter.exact() ? 15'000 : 1500;
  const double begin = static_cast<double>(jitter.seed());
  return jumps_along(pressed_boxes(jitter), steps, [&](int step) -> Vec3 {
    const double angle = begin + turn * step;
    return {radius * std::cos(angle), radius * std::sin(angle), -depth};
  });
}

Outcome probe_on_contact(Jitter& jitter) {
  SceneOf scene = pressed_boxes(jitter);
  scene.probes[0].at.z() = scene.bodies[0].offset.z();  // on the underside, which meets the lower box
  return jumps_along(scene, 1500, [&](int step) -> Vec3 { return -step * kMicrometre * Vec3::UnitZ(); });
}

Outcome noisy_probe(Jitter& jitter) {
  constexpr double kNoise = 10e-6;  // [m]
  const auto file = write_scene(pressed_boxes(jitter));
  const double L = steepest(compiled(file, "exact"));
  const Vec3 middle = jitter.of(Vec3(0, 0, -1.2e-3));
  return of_each_law(kRounding, [&](std::string_view law, Outcome&) {
    const sim::Model model = compiled(file, law);
    sim::Simulation simulation(model);
    std::mt19937_64 random(5);
    std::normal_distribution<double> noise(0.0, kNoise);
    const Vec3 still = step_to(simulation, middle).probe_forces[0];
    double force = 0.0, place = 0.0;
    for (int cycle = 0; cycle < 1000; ++cycle) {
      const Vec3 off(noise(random), noise(random), noise(random));
      force += (step_to(simulation, middle + off).probe_forces[0] - still).squaredNorm();
      place += off.squaredNorm();
    }
    return std::sqrt(force) / (L * std::sqrt(place));
  });
}

Outcome million_cycles(Jitter& jitter) {
  // With jitter, and where sanitizers slow it down by 30 times, fewer.
  const int cycles = jitter.exact() && palpate::test::kHeapIsCounted ? 1'000'000 : 10'000;
  SceneOf scene = two_boxes(jitter, {.upper_cells = 4, .lower_cells = 5});
  scene.probes[0].kind = "kind = \"pad\"\nradius = \"9 mm\"";
  const auto file = write_scene(scene);
  const sim::Model model = compiled(file, "exact");
  const double L = steepest(model);
  sim::Simulation simulation(model);
  std::mt19937_64 random(jitter.seed());
  std::uniform_real_distribution<double> within(-1.0, 1.0);
  Outcome outcome{.limit = kRounding};
  for (int cycle = 0; cycle < cycles; ++cycle) {
    // Nine of ten within a workspace of 3 mm, the others up to a metre off.
    const double size = cycle % 10 == 9 ? std::pow(10.0, -2.5 + 2.5 * within(random)) : 3e-3;
    const Vec3 there = size * Vec3(within(random), within(random), within(random));
    const sim::CycleResult result = step_to(simulation, there);
    if (!(result.solve.stop == sim::Stop::Converged && result.solve.residual <= 1e-9))
      outcome.faults.push_back("a cycle is not solved");
    if (!simulation.loads().on_body[1].allFinite()) outcome.faults.push_back("a load is not finite");
    outcome.figure = std::max(outcome.figure, result.probe_forces[0].norm() / (L * there.norm()));
    if (!std::isfinite(outcome.figure) || outcome.faults.size() > 3) break;
  }
  return outcome;
}

}  // namespace palpate::hard_cases
