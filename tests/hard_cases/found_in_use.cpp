// 51, 55, 56, 57: what users' scenes brought up.
#include <algorithm>
#include <cmath>

#include "tests/hard_cases/refusal.hpp"
#include "tests/hard_cases/residual.hpp"
#include "tests/hard_cases/runs.hpp"
#include "tests/hard_cases/scenes.hpp"
#include "tests/sim/support/box_mesh.hpp"

namespace palpate::hard_cases {

Outcome touching_at_rest(Jitter& jitter) {
  // They stand where sums of heights are rounded.
  SceneOf scene = two_boxes(jitter, {.gap = 0.0});
  scene.bodies[0].offset.z() = 0.1 + 20e-3;
  scene.bodies[1].offset = Vec3(0, 0, 0.1);
  scene.probes[0].at.z() += 0.1;
  SceneOf raised = scene;
  raised.bodies[0].offset.z() += 1e-12;
  const auto touching = write_scene(scene), apart_by_a_hair = write_scene(raised);
  return of_all_laws(
      1e-7, [&](std::string_view law, Outcome& outcome) {  // 1e-12 m of 1e-4 m and more, tenfold
        const sim::Model a = compiled(touching, law), b = compiled(apart_by_a_hair, law);
        sim::Simulation on(a), off(b);
        double farthest = 0.0;
        for (const double depth : {1e-4, 3e-4, 1e-3, 2e-3}) {
          const Vec3 there = jitter.of(Vec3(0, 0, -depth));
          const sim::CycleResult one = step_to(on, there), other = step_to(off, there);
          outcome.expect(one.pairs[0].active > 0 && one.pairs[0].active == other.pairs[0].active,
                         "other contacts");
          farthest = std::max(farthest, apart(one.probe_forces[0], other.probe_forces[0]));
        }
        return farthest;
      });
}

Outcome probe_on_fixed_node(Jitter& jitter) {
  SceneOf scene = two_boxes(jitter);
  ProbeOf& probe = scene.probes[0];
  probe.kind = "kind = \"point\"";
  probe.at = Vec3(probe.at.x() - 15e-3, probe.at.y(), probe.at.z());  // on the side, which is fixed
  Outcome outcome;
  const std::string place = refusal_of(write_scene(scene), {});
  outcome.expect(says(place, "probes.finger"), "at: " + place);
  const std::string node =
      refusal_of(write_scene(scene), std::vector<sim::Override>{{"probes.finger.node", "1"}});
  outcome.expect(says(node, "probes.finger"), "node: " + node);
  return outcome;
}

Outcome two_probes_one_node(Jitter& jitter) {
  SceneOf scene = two_boxes(jitter);
  ProbeOf thumb = scene.probes[0];
  thumb.name = "thumb";
  scene.probes.push_back(thumb);
  scene.probes[1].at += jitter.of(Vec3(5e-3, 0, 0));  // to the next node, which the first pad holds, too
  Outcome outcome;
  const std::string pads = refusal_of(write_scene(scene), {});
  outcome.expect(says(pads, "probes.thumb") && says(pads, "probes.finger"), "pads: " + pads);
  scene.probes[1] = thumb;
  for (ProbeOf& probe : scene.probes) probe.kind = "kind = \"point\"";
  const std::string points = refusal_of(write_scene(scene), {});
  outcome.expect(says(points, "probes.thumb") && says(points, "probes.finger"), "points: " + points);
  return outcome;
}

Outcome one_layer(Jitter& jitter) {
  // A membrane of 1 mm, held at its sides, pressed on a block: every node of it is on its surface.
  SceneOf scene = two_boxes(jitter);
  scene.bodies[0].mesh = jitter.of(box_with_sides(8, 1, Vec3(30e-3, 30e-3, 1e-3)), 0.5e-3);
  scene.probes[0].at.z() = scene.bodies[0].offset.z() + 1e-3;
  const sim::Model model = compiled(scene, "exact");
  sim::Simulation simulation(model);
  Outcome outcome{.limit = 1e-8};
  double before = 0.0;
  for (int step = 1; step <= 20; ++step) {
    const sim::CycleResult result = step_to(simulation, Vec3(0, 0, -0.15e-3 * step));
    const double force = result.probe_forces[0].z();
    outcome.expect(force > before, "the force does not rise");
    before = force;
    if (result.pairs[0].active > 0)
      outcome.figure = std::max(outcome.figure, residual_from_stiffness(model, simulation));
  }
  outcome.expect(outcome.figure > 0.0, "nothing touches");
  return outcome;
}

}  // namespace palpate::hard_cases
