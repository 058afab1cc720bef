// Cycles of a small scene, for a look from outside at what they execute (only_called_for.py).
//   cycles MODEL PROBE   the two boxes under a contact model, pressed by a point or a pad

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/contact/laws.hpp"
#include "sim/cycle/press.hpp"
#include "sim/effects/effects.hpp"
#include "sim/probe/kinds.hpp"
#include "tests/sim/support/two_boxes.hpp"

// What is counted, by these names. Making a simulation takes memory, whose price hangs on what was taken before, so it is
// looked at by itself.
extern "C" {

[[gnu::noinline]] void make_simulation(const palpate::sim::Model& model,
                                       std::optional<palpate::sim::Simulation>& simulation) {
  simulation.emplace(model);
}

/// To and fro along the poses. @return the last force [N]
[[gnu::noinline]] double run_cycles(palpate::sim::Simulation& simulation,
                                    const std::vector<std::vector<palpate::sim::ProbeDisplacement>>& poses,
                                    int cycles) {
  double force = 0.0;
  for (int i = 0; i < cycles; ++i) {
    const palpate::sim::CycleResult result =
        simulation.step(poses[static_cast<std::size_t>(i) % poses.size()], palpate::sim::kCyclePeriod);
    if (!palpate::sim::solved(result.solve.stop)) std::abort();
    force = result.probe_forces.front().norm();
  }
  return force;
}
}

int main(int, char** arguments) {
  namespace sim = palpate::sim;
  const std::string_view probe = arguments[2];
  const auto scene = sim::test::write_two_boxes(
      {.divisions = 4,
       .upper_divisions = 4,
       .shift = 1.7e-3,
       .probe = probe == "pad" ? "kind = \"pad\"\nradius = \"8 mm\"" : "kind = \"point\""});
  const std::vector<sim::Override> overrides{{"contact.model", arguments[1]}};
  const sim::Model model = sim::test::compile_scene(scene, overrides);
  std::vector<std::vector<sim::ProbeDisplacement>> poses;
  for (int i = 0; i < 20; ++i)
    poses.push_back(sim::displaced_by(model, 2e-3 * (1.0 - std::abs(1.0 - 0.1 * i))));
  std::optional<sim::Simulation> simulation;
  make_simulation(model, simulation);
  const double once = run_cycles(*simulation, poses, 100);
  const double twice = run_cycles(*simulation, poses, 200);
  std::printf("%zu %.17g %.17g\n",
              sim::contact_laws().size() + sim::effects().size() + sim::probe_kinds().size(), once, twice);
  return 0;
}
