#include "app/commands/check/check_scene.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/command_line/user_cache.hpp"
#include "app/commands/check/body_warnings.hpp"
#include "sim/compile/compile.hpp"
#include "sim/cycle/press.hpp"

namespace palpate::app {

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
  check.effects = check_effects(scene, model);
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
  fmt::print("\n{}", to_text(check.effects));
}

nlohmann::ordered_json to_json(const SceneCheck& check) {
  nlohmann::ordered_json bodies;
  for (const BodyCheck& body : check.bodies)
    bodies[body.name] = {{"nodes", body.quality.nodes},
                         {"surface_nodes", body.quality.surface_nodes},
                         {"fixed_nodes", body.fixed},
                         {"colliding_nodes", body.can_collide},
                         {"tetrahedra", body.quality.tetrahedra},
                         {"min_dihedral_degree", body.quality.min_dihedral},
                         {"min_radius_ratio", body.quality.min_radius_ratio},
                         {"warnings", body.quality.warnings}};
  return {{"scene", check.name},
          {"bodies", bodies},
          {"effects", effects_json(check.effects)},
          {"probes", probes_json(check.effects)}};
}

}  // namespace palpate::app
