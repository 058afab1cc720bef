#include "sim/cycle/press.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "app/commands/commands.hpp"
#include "app/output.hpp"
#include "app/plot.hpp"
#include "app/scene_options.hpp"
#include "app/user_cache.hpp"
#include "sim/elasticity/static_solve.hpp"
#include "sim/elasticity/stress.hpp"
#include "sim/mesh/write_vtu.hpp"

namespace palpate::app {
namespace {

using nlohmann::ordered_json;

struct PressOptions {
  SceneOptions scene{};
  std::string depth;
  int steps = 10;
  std::string save;
  std::string plot;
  std::string format;
};

ordered_json to_json(const sim::Vec3& v) {
  return {v[0], v[1], v[2]};
}

std::string_view to_string(sim::Stop stop) {
  switch (stop) {
    case sim::Stop::Converged:
      return "converged";
    case sim::Stop::IterationLimit:
      return "iteration limit";
    case sim::Stop::SingularMatrix:
      return "singular matrix";
  }
  return "";
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
        {"force", to_json(step.probe_forces[i])},
        {"normal_force", sim::normal_force(model.probes[i], step.probe_forces[i])}};
  for (std::size_t i = 0; i < model.pairs.size(); ++i) {
    const auto [a, b] = model.pairs[i].bodies;
    const std::string& first = model.bodies[static_cast<std::size_t>(a)].name;
    const std::string& second = model.bodies[static_cast<std::size_t>(b)].name;
    pairs.push_back(
        {{"bodies", {first, second}},
         {"active", step.pairs[i].active},
         {"penetration", step.penetration[i]},
         {"force_on",
          {{first, to_json(step.pairs[i].force_on[0])}, {second, to_json(step.pairs[i].force_on[1])}}}});
  }
  return {{"depth", step.depth},
          {"force", to_json(step.probe_forces.front())},
          {"normal_force", sim::normal_force(model.probes.front(), step.probe_forces.front())},
          {"cycle_us", step.cycle_us},
          {"probes", probes},
          {"pairs", pairs},
          {"solve",
           {{"stop", to_string(step.solve.stop)},
            {"iterations", step.solve.iterations},
            {"residual", step.solve.residual}}}};
}

void print_json(const sim::Model& model, const sim::Press& press) {
  ordered_json curve = ordered_json::array();
  for (const sim::PressStep& step : press.curve) curve.push_back(step_json(model, step));
  const ordered_json result = {{"scene", model.scene},
                               {"model", std::string(sim::to_string(model.law))},
                               {"units", {{"length", "m"}, {"force", "N"}}},
                               {"bodies", bodies_json(model)},
                               {"curve", curve}};
  fmt::print("{}\n", result.dump(1));
}

void print_text(const sim::Model& model, const sim::Press& press) {
  fmt::print("{}, contact model {}\n", model.scene, sim::to_string(model.law));
  fmt::print("{:>10} {:>12} {:>9} {:>16} {:>11}\n", "depth [mm]", "force [N]", "contacts", "overlap [mm]",
             "cycle [us]");
  for (const sim::PressStep& step : press.curve) {
    int active = 0;
    double overlap = 0.0;
    for (std::size_t i = 0; i < step.pairs.size(); ++i) {
      active += step.pairs[i].active;
      overlap = std::max(overlap, step.penetration[i]);
    }
    fmt::print("{:>10.3f} {:>12.5f} {:>9} {:>16.4f} {:>11.1f}\n", 1e3 * step.depth,
               sim::normal_force(model.probes.front(), step.probe_forces.front()), active, 1e3 * overlap,
               step.cycle_us);
  }
}

/// STATE.body.vtu for each body, every node moved by the uncondensed problem under the last step's loads.
void save_state(const sim::Model& model, const sim::Press& press, const std::string& state) {
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const sim::Body& body = model.bodies[i];
    Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(body.mesh->nodes.size()));
    for (std::size_t t = 0; t < body.compliance->touch.size(); ++t)
      force.col(body.compliance->touch[t]) =
          press.loads.on_body[i].segment<3>(3 * static_cast<Eigen::Index>(t));
    const auto stiffness = sim::stiffness(*body.mesh, body.materials);
    const Eigen::Matrix3Xd u = sim::static_solve(stiffness, body.fixed, force);
    sim::VtuFields fields;
    fields.point_vectors = {{"displacement", u}, {"force", force}};
    fields.cell_scalars = {{"von_mises", sim::von_mises(*body.mesh, body.materials, u)}};
    const std::string file = fmt::format("{}.{}.vtu", state, body.name);
    sim::write_vtu(file, *body.mesh, fields);
    fmt::print(stderr, "wrote {}\n", file);
  }
}

/// Fig. 8: what the finger feels over its depth.
void plot(const sim::Model& model, const sim::Press& press, const std::string& file) {
  PlotSeries force{.name = std::string(sim::to_string(model.law)), .x = {0.0}, .y = {0.0}};
  for (const sim::PressStep& step : press.curve) {
    force.x.push_back(1e3 * step.depth);
    force.y.push_back(sim::normal_force(model.probes.front(), step.probe_forces.front()));
  }
  draw_plot({.title = model.scene, .x_label = "depth [mm]", .y_label = "force [N]", .series = {force}}, file);
  fmt::print(stderr, "wrote {}\n", file);
}

void run_press(const PressOptions& options) {
  if (!options.plot.empty()) check_plot_file(options.plot);
  sim::ComplianceCache cache = user_cache();
  const sim::Model model = sim::compile(load_scene(options.scene), cache);
  const double depth = options.depth.empty() ? model.probes.front().depth : parse_depth(options.depth);
  if (!(depth > 0.0)) throw std::invalid_argument(fmt::format("--depth {}: accepted: > 0", options.depth));
  const sim::Press press = sim::press(model, depth, options.steps);
  if (options.format == "json")
    print_json(model, press);
  else
    print_text(model, press);
  if (!options.save.empty()) save_state(model, press, options.save);
  if (!options.plot.empty()) plot(model, press, options.plot);
}

}  // namespace

void add_press(CLI::App& app) {
  auto options = std::make_shared<PressOptions>();
  CLI::App* command = app.add_subcommand("press", "Force over depth of a press into a scene (Fig. 8)");
  add_scene(*command, options->scene);
  command->add_option("--depth", options->depth,
                      "How deep, with its unit (default: the probe's depth in the scene)");
  command->add_option("--steps", options->steps, "Equal steps from the surface to the depth")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command->add_option("--save", options->save,
                      "Write STATE.<body>.vtu with displacement, force and von Mises stress");
  command->add_option("--plot", options->plot, "Write a plot of the force over the depth, .svg or .png");
  add_format(*command, options->format);
  command->footer(
      "Example:\n  palpate press data/scenes/rectal-palpation.toml --model kuroda --depth \"5 mm\" "
      "--set bodies.prostate.young_modulus=\"5 MPa\"");
  command->callback([options] { run_press(*options); });
}

}  // namespace palpate::app
