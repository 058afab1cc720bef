// 33: what sticks, slips, and sticks again.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/contact/frictional/frictional.hpp"
#include "tests/hard_cases/runs.hpp"
#include "tests/hard_cases/scenes.hpp"

namespace palpate::hard_cases {
namespace {

/// Down, sideways by 1.5 mm, back, and sideways again: it sticks, slips, turns round.
std::vector<Vec3> strokes(Jitter& jitter) {
  std::vector<Vec3> places;
  for (int i = 1; i <= 20; ++i) places.emplace_back(0, 0, -1.5e-3 * i / 20);
  for (int i = 1; i <= 120; ++i) {
    const double angle = 0.05 * i;
    places.push_back(jitter.of(Vec3(1.5e-3 * std::sin(angle), 0.6e-3 * std::sin(2 * angle), -1.5e-3)));
  }
  return places;
}

/// How far the tangential force of a contact is beyond its cone, as a part of the largest normal force.
double beyond_cone(const sim::Simulation& simulation, double mu) {
  const auto& scratch = static_cast<const sim::FrictionalScratch&>(*simulation.law_scratch());
  const Eigen::VectorXd& x = scratch.solve.forces();
  double beyond = 0.0, largest = 0.0;
  for (Eigen::Index row = scratch.system.bilateral; row + 2 < x.size(); row += 3) {
    beyond = std::max({beyond, x.segment<2>(row + 1).norm() - mu * x[row], -x[row]});
    largest = std::max(largest, x[row]);
  }
  return largest > 0.0 ? beyond / largest : beyond;
}

std::vector<sim::Override> with_friction(double mu) {
  return {{"contact.friction", fmt::format("{:.17g}", mu)}};
}

}  // namespace

Outcome friction(Jitter& jitter) {
  const auto file = write_scene(two_boxes(jitter));
  const std::vector<Vec3> places = strokes(jitter);
  Outcome outcome{.limit = 1e-8};
  for (const double mu : {0.0, jitter.of(0.3), jitter.of(1.5)}) {
    const sim::Model model = compiled(file, "exact", with_friction(mu));
    sim::Simulation first(model), second(model);
    for (const Vec3& place : places) {
      const sim::CycleResult result = step_to(first, place);
      outcome.expect(result.solve.stop == sim::Stop::Converged && result.solve.residual <= 1e-10,
                     fmt::format("mu = {}: a cycle is not solved", mu));
      outcome.figure = std::max(outcome.figure, beyond_cone(first, mu));
      outcome.expect(step_to(second, place).probe_forces[0] == result.probe_forces[0],
                     fmt::format("mu = {}: another solution the second time", mu));
    }
  }
  const Vec3 there = places[30], free = force_at(compiled(file, "exact"), there);
  double before = INFINITY;
  for (const double mu : {0.1, 0.01, 0.001, 0.0}) {
    const double left = apart(force_at(compiled(file, "exact", with_friction(mu)), there), free);
    outcome.expect(left < 0.2 * before, "it does not tend to exact");
    before = left;
  }
  outcome.expect(before <= 1e-9, "at mu = 0 it is not exact");
  return outcome;
}

}  // namespace palpate::hard_cases
