#include "app/commands/check/check_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "app/command_line/user_cache.hpp"
#include "app/commands/check/body_warnings.hpp"
#include "sim/compile/compile.hpp"
#include "sim/cycle/press.hpp"
#include "sim/effects/effects.hpp"

namespace palpate::app {
namespace {

/// Median time of a cycle at full depth [microseconds], over cycles enough for a stable median.
double median_cycle_us(const sim::Model& model) {
  sim::Simulation simulation(model);
  const auto probes = sim::displaced_by(model, model.probes.front().depth);
  std::vector<double> times;
  for (int i = 0; i < 2000; ++i) {
    const auto before = std::chrono::steady_clock::now();
    simulation.step(probes, sim::kCyclePeriod);
    times.push_back(
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - before).count());
  }
  std::ranges::nth_element(times, times.begin() + 1000);
  return times[1000];
}

}  // namespace

SceneCheck check_scene(const SceneOptions& input) {
  const sim::Scene scene = load_scene(input);
  sim::ComplianceCache cache = user_cache();
  const sim::Model model = sim::compile(scene, cache);
  sim::require_solved(sim::press(model, model.probes.front().depth, 1));
  SceneCheck check{.name = scene.name};
  for (const sim::Body& body : model.bodies)
    check.bodies.push_back(
        {body.name, sim::measure_quality(*body.mesh), body.fixed.size(), body.colliding_nodes.size()});
  for (std::size_t i = 0; i < model.bodies.size(); ++i)
    for (std::string& warning : body_warnings(model, model.bodies[i]))
      check.bodies[i].quality.warnings.push_back(std::move(warning));
  const double whole = median_cycle_us(model);
  sim::Model bare = model;
  for (const sim::Effect* effect : sim::effects()) {
    EffectCheck found{.name = effect->name, .state = effect->state(scene)};
    if (found.state.on) {
      bare = effect->without(std::move(bare));
      found.cycle_us = std::max(0.0, whole - median_cycle_us(effect->without(model)));
    }
    check.effects.push_back(std::move(found));
  }
  check.deformation_us = median_cycle_us(bare);
  return check;
}

void print_text(const SceneCheck& check) {
  fmt::print("{}: a sound scene\n\nbodies\n", check.name);
  for (const BodyCheck& body : check.bodies) {
    const sim::MeshQuality& q = body.quality;
    fmt::print("  {}: {} nodes ({} of the surface, {} fixed, {} can collide), {} tetrahedra\n", body.name,
               q.nodes, q.surface_nodes, body.fixed, body.can_collide, q.tetrahedra);
    fmt::print(
        "    dihedral angles {:.1f} to {:.1f} degrees, radius ratio {:.2f} at worst, {:.2f} on average\n",
        q.min_dihedral, q.max_dihedral, q.min_radius_ratio, q.mean_radius_ratio);
    for (const std::string& warning : q.warnings) fmt::print("    warning: {}\n", warning);
  }
  fmt::print("\n{:<27}{:<5}{:>13}  {}\n", "effects", "", "us a cycle", "why");
  fmt::print("  {:<25}{:<5}{:>13.1f}  {}\n", "linear elasticity", "on", check.deformation_us, "every scene");
  for (const EffectCheck& effect : check.effects)
    fmt::print("  {:<25}{:<5}{:>13}  {}\n", effect.name, effect.state.on ? "on" : "off",
               effect.state.on ? fmt::format("{:.1f}", effect.cycle_us) : "0", effect.state.reason);
  fmt::print("\nMedian times on this machine, probes at their full depth.\n");
}

nlohmann::ordered_json to_json(const SceneCheck& check) {
  nlohmann::ordered_json bodies, effects = nlohmann::ordered_json::array();
  for (const BodyCheck& body : check.bodies)
    bodies[body.name] = {{"nodes", body.quality.nodes},
                         {"surface_nodes", body.quality.surface_nodes},
                         {"fixed_nodes", body.fixed},
                         {"colliding_nodes", body.can_collide},
                         {"tetrahedra", body.quality.tetrahedra},
                         {"min_dihedral_degree", body.quality.min_dihedral},
                         {"min_radius_ratio", body.quality.min_radius_ratio},
                         {"warnings", body.quality.warnings}};
  effects.push_back({{"effect", "linear elasticity"},
                     {"on", true},
                     {"why", "every scene"},
                     {"cycle_us", check.deformation_us}});
  for (const EffectCheck& effect : check.effects)
    effects.push_back({{"effect", std::string(effect.name)},
                       {"on", effect.state.on},
                       {"why", effect.state.reason},
                       {"cycle_us", effect.cycle_us}});
  return {{"scene", check.name}, {"bodies", bodies}, {"effects", effects}};
}

}  // namespace palpate::app
