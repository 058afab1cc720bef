// 26, 36, 53, 54: action and reaction, and the sign of the force.
#include <algorithm>
#include <cmath>

#include "tests/hard_cases/runs.hpp"
#include "tests/hard_cases/scenes.hpp"
#include "tests/sim/support/box_mesh.hpp"

namespace palpate::hard_cases {
namespace {

constexpr const char* kPoint = "kind = \"point\"";

/// What resists a press, at each of `steps` depths.
struct Pressed {
  std::vector<double> force{};  // of the first probe against its direction [N]
  std::vector<int> active{};    // contacts of the first pair of bodies
};

Pressed pressed(const sim::Model& model, double depth, int steps) {
  sim::Simulation simulation(model);
  Pressed press;
  for (int step = 1; step <= steps; ++step) {
    std::vector<sim::ProbeDisplacement> probes;
    for (const sim::Probe& probe : model.probes)
      probes.push_back({Vec3(depth * step / steps * probe.direction)});
    const sim::CycleResult result = simulation.step(probes, sim::kCyclePeriod);
    for (std::size_t p = 0; p < model.probes.size(); ++p)  // the least of all probes
      if (const double back = -result.probe_forces[p].dot(model.probes[p].direction); p == 0)
        press.force.push_back(back);
      else
        press.force.back() = std::min(press.force.back(), back);
    press.active.push_back(result.pairs[0].active);
  }
  return press;
}

double least_part(const std::vector<double>& values) {
  return std::ranges::min(values) / std::ranges::max(values);
}

/// A slab of 3 mm held at two sides, on a block.
SceneOf slab_on_block(Jitter& jitter) {
  SceneOf scene = two_boxes(jitter, {.lower_cells = 7, .gap = 0.0, .shift = 0.0});
  TetMesh slab = sim::test::box_mesh(6, 6, 1, Vec3(30e-3, 30e-3, 3e-3));
  slab.node_groups["ends"] = sim::test::nodes_of(slab, {"x_min", "x_max"});
  slab.node_groups["free"] = sim::test::nodes_of(slab, {"y_min", "y_max", "z_min", "z_max"});
  scene.bodies[0] = {.name = "upper",
                     .mesh = slab,
                     .fixed = "\"ends\"",
                     .touchable = "\"free\"",
                     .modulus = jitter.of(1e6),
                     .offset = Vec3(0, 0, 20e-3)};
  scene.bodies[1].offset = jitter.of(Vec3(0.21e-3, 0.13e-3, 0.0));
  scene.probes = {{.kind = kPoint, .at = Vec3(15e-3, 15e-3, 23e-3)}};
  return scene;
}

}  // namespace

Outcome held_and_touched(Jitter& jitter) {
  SceneOf scene = two_boxes(jitter);
  // Two pads: the finger on the upper box, and one on the lower box's top, some of whose nodes are in contact.
  const Vec3 middle(15e-3, 15e-3, 20e-3);
  scene.probes.push_back({.name = "thumb", .body = "lower", .at = middle, .direction = Vec3::UnitZ()});
  const auto file = write_scene(scene);
  const double finger = jitter.of(2e-3), thumb = jitter.of(0.3e-3);
  return of_each_law(1e-9, [&](std::string_view law, Outcome& outcome) {
    const sim::Model model = compiled(file, law);
    sim::Simulation simulation(model);
    const std::vector<sim::ProbeDisplacement> probes{{Vec3(0, 0, -finger)}, {Vec3(0, 0, thumb)}};
    const sim::CycleResult result = simulation.step(probes, sim::kCyclePeriod);
    const Vec3 &action = result.pairs[0].force_on[0], &reaction = result.pairs[0].force_on[1];
    outcome.expect(action.norm() > 0.0, "nothing touches");
    return (action + reaction).norm() / action.norm();
  });
}

Outcome pinched(Jitter& jitter) {
  // A leaf of 2 mm, held at its sides, between two boxes that press it from above and below; 4 mm together.
  SceneOf scene = two_boxes(jitter);
  scene.bodies.push_back(
      {.name = "leaf",
       .mesh = jitter.of(box_with_sides(7, 1, Vec3(33e-3, 33e-3, 2e-3)), 0.5e-3),
       .fixed = "\"sides\"",
       .touchable = R"({ lower = ["-1 m", "-1 m", "-1 m"], upper = ["1 m", "1 m", "1 m"] })",
       .offset = Vec3(-1e-3, -1e-3, 17.8e-3)});
  scene.bodies[0].offset.z() = 20e-3;
  TetMesh below = jitter.of(box_with_sides(5, 2, Vec3(30e-3, 30e-3, 5e-3)), 1e-3);
  scene.bodies[1] = {.name = "lower",
                     .mesh = below,
                     .fixed = "\"sides\"",
                     .touchable = "\"z_max\"",
                     .modulus = jitter.of(1e6),
                     .offset = Vec3(0.6e-3, 0.9e-3, 12.6e-3)};
  scene.touch = R"([["upper", "leaf"], ["leaf", "lower"]])";
  scene.probes[0].at = Vec3(16.7e-3, 16.7e-3, 25e-3);
  scene.probes.push_back(
      {.name = "thumb", .body = "lower", .at = Vec3(15.6e-3, 15.9e-3, 12.6e-3), .direction = Vec3::UnitZ()});
  const auto file = write_scene(scene);
  return of_all_laws(
      0.0,
      [&](std::string_view law, Outcome& outcome) {
        const Pressed press = pressed(compiled(file, law), jitter.of(2e-3), 40);
        outcome.expect(press.active.back() > 0, "nothing touches");
        return least_part(press.force);
      },
      Bound::AtLeast);
}

Outcome through_thickness(Jitter& jitter) {
  const auto file = write_scene(slab_on_block(jitter));
  return of_all_laws(
      0.0,
      [&](std::string_view law, Outcome& outcome) {
        const sim::Model model = compiled(file, law);
        const Pressed press = pressed(model, jitter.of(6e-3), 60);  // twice the thickness
        outcome.expect(std::ranges::min(press.active) > 0, "contact is lost");
        if (law != "exact")  // whose closed contacts may open where the slab bends
          outcome.expect(std::ranges::min(press.active) == press.active.front(), "a contact is lost");
        double least = INFINITY;
        for (std::size_t i = 1; i < press.force.size(); ++i)
          least = std::min(least, press.force[i] - press.force[i - 1]);
        return least * static_cast<double>(press.force.size()) / press.force.back();
      },
      Bound::AtLeast);
}

Outcome sign_of_force(Jitter& jitter) {
  const std::vector<SceneOf> scenes{two_boxes(jitter), two_boxes(jitter, {.gap = 0.0}),
                                    slab_on_block(jitter)};
  return of_all_laws(
      0.0,
      [&](std::string_view law, Outcome&) {
        double least = INFINITY;
        for (const SceneOf& scene : scenes)
          least = std::min(least, least_part(pressed(compiled(scene, law), jitter.of(4e-3), 80).force));
        return least;
      },
      Bound::AtLeast);
}

}  // namespace palpate::hard_cases
