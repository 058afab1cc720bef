// 28, 29, 30: bodies in each other, jumps through walls, gaps of nothing.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/hard_cases/refusal.hpp"
#include "tests/hard_cases/runs.hpp"
#include "tests/hard_cases/scenes.hpp"

namespace palpate::hard_cases {

Outcome deep_overlap(Jitter& jitter) {
  const auto scene = write_scene(two_boxes(jitter, {.gap = 0.0}));
  const double deep = jitter.of(1e-3);
  const std::string lowered = fmt::format(R"(["1.7 mm", "1.7 mm", "{:.17g} m"])", 20e-3 - deep);
  const std::vector<sim::Override> overlapping{{"bodies.upper.offset", lowered}};
  std::vector<sim::Override> declared = overlapping;
  declared.push_back({"contact.overlap", fmt::format("\"{:.17g} m\"", 1.01 * deep)});
  // Nothing is felt at depth 0: what is felt at 1 nm is a millionth of that at 1 mm, as far as it is linear.
  return of_all_laws(1e-5, [&](std::string_view law, Outcome& outcome) {
    std::vector<sim::Override> undeclared = overlapping;
    undeclared.push_back({"contact.model", std::string(law)});
    const std::string refusal = refusal_of(scene, undeclared);
    outcome.expect(says(refusal, "contact.overlap") && says(refusal, "mm"),
                   "an overlap is taken: " + refusal);
    const sim::Model model = compiled(scene, law, declared);
    return force_at(model, Vec3(0, 0, -1e-9)).norm() / force_at(model, Vec3(0, 0, -1e-3)).norm();
  });
}

Outcome jump_through_wall(Jitter& jitter) {
  const auto scene = write_scene(two_boxes(jitter));
  const Vec3 beyond = jitter.of(Vec3(0.1e-3, 0.2e-3, -6e-3));  // the upper box is 5 mm thick
  return of_all_laws(1e-9, [&](std::string_view law, Outcome& outcome) {
    const sim::Model model = compiled(scene, law);
    sim::Simulation slow(model);
    Vec3 by_steps = Vec3::Zero();
    for (int step = 1; step <= 100; ++step) by_steps = step_to(slow, beyond * step / 100).probe_forces[0];
    sim::Simulation fast(model);
    const sim::CycleResult result = step_to(fast, beyond);
    outcome.expect(result.pairs[0].active > 0, "nothing touches");
    return apart(result.probe_forces[0], by_steps);
  });
}

Outcome grazing_contact(Jitter& jitter) {
  const auto scene = write_scene(two_boxes(jitter, {.gap = 0.0}));
  const double L = steepest(compiled(scene, "exact"));
  return of_each_law(1.0 + 1e-6, [&](std::string_view law, Outcome& outcome) {
    const sim::Model model = compiled(scene, law);
    sim::Simulation simulation(model);
    double largest = 0.0;
    for (double depth = 1e-15; depth < 1e-4; depth *= 10)
      for (const Vec3& slant :
           {Vec3(0, 0, 0), Vec3(1e-3, 0, 0), Vec3(-1e-5, 1e-4, 0), Vec3(1e-9, 1e-12, 0)}) {
        const Vec3 there = jitter.of(Vec3(slant - Vec3(0, 0, depth)));
        const Vec3 force = step_to(simulation, there).probe_forces[0];
        outcome.expect(force.allFinite(), "a force is not finite");
        largest = std::max(largest, force.norm() / (L * there.norm()));
      }
    return largest;
  });
}

}  // namespace palpate::hard_cases
