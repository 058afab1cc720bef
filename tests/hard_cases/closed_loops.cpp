// 49: work round closed ways, and the force as the slope of the stored energy.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/hard_cases/runs.hpp"
#include "tests/hard_cases/scenes.hpp"

namespace palpate::hard_cases {
namespace {

/// A knot in space below the skin, at a part of its way: it goes round in all three directions and never the way back.
Vec3 knot(double part, double size) {
  const double t = 2 * std::numbers::pi * part;
  return size * Vec3(0.8 * std::sin(2 * t + 0.3), 0.7 * std::sin(3 * t),
                     -2.0 + 0.9 * std::cos(t) + 0.3 * std::sin(5 * t));
}

/// Work of the hand along a straight piece of its way [J]. The force of `exact` is linear between the places at which a
/// contact comes or goes, where the mean of both ends is exact: pieces that hold such a place are halved.
double work_along(sim::Simulation& simulation, const Vec3& a, const Vec3& b, const Vec3& force_a,
                  const Vec3& force_b, int halvings) {
  const Vec3 middle = 0.5 * (a + b), force = step_to(simulation, middle).probe_forces[0];
  const Vec3 mean = 0.5 * (force_a + force_b);
  if (halvings == 0 || (force - mean).norm() <= 1e-11 * force.norm()) return -mean.dot(b - a);
  return work_along(simulation, a, middle, force_a, force, halvings - 1) +
         work_along(simulation, middle, b, force, force_b, halvings - 1);
}

/// |work round the knot| / largest energy stored on the way.
double work_round(const sim::Model& model, double size, int halvings) {
  constexpr int kPieces = 300;
  sim::Simulation simulation(model);
  double work = 0.0, stored = 0.0;
  Vec3 before = knot(0.0, size), force = step_to(simulation, before).probe_forces[0];
  for (int piece = 1; piece <= kPieces; ++piece) {
    const Vec3 here = knot(static_cast<double>(piece % kPieces) / kPieces, size);
    const Vec3 now = step_to(simulation, here).probe_forces[0];
    stored = std::max(stored, stored_energy(model, simulation));
    work += work_along(simulation, before, here, force, now, halvings);
    before = here;
    force = now;
  }
  return std::abs(work) / stored;
}

/// How far the force is from the slope of the stored energy, by central differences.
double off_the_slope(const sim::Model& model, const Vec3& there) {
  constexpr double kStep = 1e-7;  // [m]
  sim::Simulation simulation(model);
  const auto energy = [&](const Vec3& place) {
    step_to(simulation, place);
    return stored_energy(model, simulation);
  };
  Vec3 slope;
  for (int k = 0; k < 3; ++k)
    slope[k] = (energy(there + kStep * Vec3::Unit(k)) - energy(there - kStep * Vec3::Unit(k))) / (2 * kStep);
  return apart(-slope, step_to(simulation, there).probe_forces[0]);
}

}  // namespace

Outcome closed_loops(Jitter& jitter) {
  const auto file = write_scene(two_boxes(jitter));
  const double size = jitter.of(1e-3);
  return of_each_law(1e-6, [&](std::string_view law, Outcome& outcome) {
    const sim::Model model = compiled(file, law);
    if (law == "exact")
      for (const double part : {0.1, 0.4, 0.7})
        outcome.expect(off_the_slope(model, knot(part, size)) <= 1e-6,
                       "the force is not the slope of the energy");
    return work_round(model, size, law == "exact" ? 24 : 4);
  });
}

}  // namespace palpate::hard_cases
