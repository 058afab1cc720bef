#include "app/commands/press/press_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace palpate::app {
namespace {

using nlohmann::ordered_json;

ordered_json vector_json(const sim::Vec3& v) {
  return {v[0], v[1], v[2]};
}

ordered_json bodies_json(const sim::Model& model) {
  ordered_json bodies;
  for (const sim::Body& body : model.bodies) {
    const std::set<int> fixed(body.fixed.begin(), body.fixed.end());
    std::size_t free_surface = 0;
    for (const int node : body.surface->nodes) free_surface += fixed.contains(node) ? 0 : 1;
    bodies[body.name] = {{"nodes", body.mesh->nodes.size()},
                         {"free_surface_nodes", free_surface},
                         {"tetrahedra", body.mesh->tetrahedra.size()}};
  }
  return bodies;
}

ordered_json step_json(const sim::Model& model, const sim::PressStep& step) {
  ordered_json probes, pairs = ordered_json::array();
  for (std::size_t i = 0; i < model.probes.size(); ++i)
    probes[model.probes[i].name] = {
        {"force", vector_json(step.probe_forces[i])},
        {"normal_force", sim::normal_force(model.probes[i], step.probe_forces[i])}};
  for (std::size_t i = 0; i < model.pairs.size(); ++i) {
    const auto [a, b] = model.pairs[i].bodies;
    const std::string& first = model.bodies[a].name;
    const std::string& second = model.bodies[b].name;
    pairs.push_back({{"bodies", {first, second}},
                     {"active", step.pairs[i].active},
                     {"penetration", step.penetration[i]},
                     {"force_on",
                      {{first, vector_json(step.pairs[i].force_on[0])},
                       {second, vector_json(step.pairs[i].force_on[1])}}}});
  }
  return {{"depth", step.depth},
          {"force", vector_json(step.probe_forces.front())},
          {"normal_force", sim::normal_force(model.probes.front(), step.probe_forces.front())},
          {"cycle_us", step.cycle_us},
          {"probes", probes},
          {"pairs", pairs},
          {"solve",
           {{"stop", sim::to_string(step.solve.stop)},
            {"iterations", step.solve.iterations},
            {"residual", step.solve.residual},
            {"force_error_bound", step.solve.force_error_bound}}}};
}

}  // namespace

ordered_json press_json(const sim::Model& model, const sim::Press& press) {
  ordered_json curve = ordered_json::array();
  for (const sim::PressStep& step : press.curve) curve.push_back(step_json(model, step));
  return {{"scene", model.scene},
          {"model", std::string(model.law->name)},
          {"units", {{"length", "m"}, {"force", "N"}}},
          {"bodies", bodies_json(model)},
          {"curve", curve}};
}

std::string press_text(const sim::Model& model, const sim::Press& press) {
  std::string text =
      fmt::format("{}, contact model {}\n{:>10} {:>12} {:>9} {:>16} {:>11}\n", model.scene, model.law->name,
                  "depth [mm]", "force [N]", "contacts", "overlap [mm]", "cycle [us]");
  for (const sim::PressStep& step : press.curve) {
    int active = 0;
    double overlap = 0.0;
    for (std::size_t i = 0; i < step.pairs.size(); ++i) {
      active += step.pairs[i].active;
      overlap = std::max(overlap, step.penetration[i]);
    }
    text += fmt::format("{:>10.3f} {:>12.5f} {:>9} {:>16.4f} {:>11.1f}\n", 1e3 * step.depth,
                        sim::normal_force(model.probes.front(), step.probe_forces.front()), active,
                        1e3 * overlap, step.cycle_us);
  }
  return text;
}

}  // namespace palpate::app
