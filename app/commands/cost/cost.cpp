#include "app/commands/cost/cost.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/command_line/output.hpp"
#include "app/command_line/plot.hpp"
#include "app/command_line/scene_options.hpp"
#include "app/command_line/user_cache.hpp"
#include "app/commands/cost/tolerances.hpp"
#include "base/machine/machine.hpp"
#include "sim/compile/compile.hpp"
#include "sim/contact/laws.hpp"
#include "sim/cost/cycle_cost.hpp"
#include "sim/cost/tolerance_cost.hpp"

namespace palpate::app {
namespace {

using nlohmann::ordered_json;

struct CostOptions {
  std::vector<std::string> scenes;
  SceneOptions common{};  // of all scenes; its file is not used
  std::string depth;
  std::string plot;
  std::string format;
};

struct ModelCost {
  sim::CycleCost cycle;
  std::vector<sim::ToleranceCost> tolerances{};  // empty: the contact model knows no bound of an error
};

struct SceneCost {
  std::string scene;
  int nodes = 0;      // of all bodies, as the paper counts them
  int touchable = 0;  // of these
  std::vector<ModelCost> models;
};

// [Kuroda2003] sections 4 and 5.1, on one Pentium III of 933 MHz.
constexpr double kPaperDeformation = 1170.0, kPaperInteraction = 1620.0, kPaperTotal = 2880.0;  // [us]
constexpr int kPaperNodes = 642;                                                                // Table 1
constexpr const char* kPaperSource =
    "Kuroda et al. 2003, section 5.1, rectal palpation (Table 1), Pentium III 933 MHz";

// Of the force: from a solution to the end to what a hand would notice.
constexpr double kTolerances[] = {0.0, 0.001, 0.01, 0.05, 0.2};

std::string versions() {
  return fmt::format("palpate {}, GCC {}", PALPATE_VERSION, __VERSION__);
}

SceneCost measure(const CostOptions& options, const std::string& file, sim::ComplianceCache& cache) {
  SceneOptions scene = options.common;
  scene.file = file;
  const sim::Model model = sim::compile(load_scene(scene), cache);
  SceneCost cost{.scene = model.scene, .models = {}};
  for (const sim::Body& body : model.bodies) {
    cost.nodes += static_cast<int>(body.mesh->nodes.size());
    cost.touchable += static_cast<int>(body.rest.cols());
  }
  sim::CycleSampling how{.depth =
                             options.depth.empty() ? model.probes.front().depth : parse_depth(options.depth)};
  if (!(how.depth > 0.0))
    throw std::invalid_argument(fmt::format("--depth {}: accepted: > 0", options.depth));
  for (const sim::ContactLaw* law : sim::contact_laws())
    if (options.common.model.empty() || law == model.law)
      cost.models.push_back({.cycle = sim::measure_cycle(model, *law, how),
                             .tolerances = sim::measure_tolerances(model, *law, how, kTolerances)});
  return cost;
}

void print_row(const std::string& model, const std::string& contacts, const char* what,
               const sim::Percentiles& times) {
  fmt::print("{:<9} {:>8}  {:<12} {:>9.2f} {:>9.2f} {:>9.2f} {:>9.2f}\n", model, contacts, what, times.median,
             times.p99, times.p999, times.slowest);
}

void print_text(const std::vector<SceneCost>& costs) {
  fmt::print("Time of one haptic cycle [microseconds]\n{}\n{}\n", base::describe_machine(), versions());
  for (const SceneCost& scene : costs) {
    const sim::CycleCost& first = scene.models.front().cycle;
    fmt::print("\n{}: {} nodes, {} of them touchable; {} poses {:.3g} to {:.3g} mm deep, {}\n", scene.scene,
               scene.nodes, scene.touchable, first.depths.size(), 1e3 * first.depths.front(),
               1e3 * first.depths.back(), first.touching ? "bodies touching" : "no bodies touch");
    fmt::print("{:<9} {:>8}  {:<12} {:>9} {:>9} {:>9} {:>9}\n", "model", "contacts", "", "median", "p99",
               "p99.9", "slowest");
    for (const ModelCost& model : scene.models) {
      const sim::CycleCost& cost = model.cycle;
      print_row(std::string(cost.law), std::to_string(cost.active), "deformation", cost.deformation);
      print_row("", "", "interaction", cost.interaction);
      print_row("", "", "total", cost.total);
      fmt::print(
          "{:<20}{:.1f} times the limit: {:.3f} us to read the final contact set's compliance once ({:.1f} "
          "kB)\n",
          "", cost.total.median / cost.limit, cost.limit, 1e-3 * static_cast<double>(cost.limit_bytes));
      fmt::print("{:<20}{} cycles, interrupted {} times by other programs\n", "", cost.cycles,
                 cost.interruptions);
      if (!model.tolerances.empty()) print_tolerances(model.tolerances);
    }
  }
  fmt::print("\nPublished: deformation {:.0f}, interaction {:.0f}, total {:.0f} us with {} nodes ({})\n",
             kPaperDeformation, kPaperInteraction, kPaperTotal, kPaperNodes, kPaperSource);
}

ordered_json to_json(const sim::Percentiles& times) {
  return {{"median", times.median}, {"p99", times.p99}, {"p99_9", times.p999}, {"slowest", times.slowest}};
}

ordered_json to_json(const ModelCost& model) {
  const sim::CycleCost& cost = model.cycle;
  return {{"model", std::string(cost.law)},
          {"touching", cost.touching},
          {"active", cost.active},
          {"cycles", cost.cycles},
          {"interruptions", cost.interruptions},
          {"deformation", to_json(cost.deformation)},
          {"interaction", to_json(cost.interaction)},
          {"total", to_json(cost.total)},
          {"limit",
           {{"time", cost.limit}, {"bytes", cost.limit_bytes}, {"ratio", cost.total.median / cost.limit}}},
          {"depth", cost.depths},
          {"total_median_at_depth", cost.depth_medians},
          {"total_p99_9_at_depth", cost.depth_p999},
          {"tolerances", tolerances_json(model.tolerances)}};
}

void print_costs(const std::vector<SceneCost>& costs) {
  ordered_json scenes = ordered_json::array();
  for (const SceneCost& scene : costs) {
    ordered_json models = ordered_json::array();
    for (const ModelCost& model : scene.models) models.push_back(to_json(model));
    scenes.push_back({{"scene", scene.scene},
                      {"nodes", scene.nodes},
                      {"touchable_nodes", scene.touchable},
                      {"models", models}});
  }
  const ordered_json result = {{"units", {{"time", "us"}, {"depth", "m"}}},
                               {"machine", base::describe_machine()},
                               {"versions", versions()},
                               {"scenes", scenes},
                               {"published",
                                {{"source", kPaperSource},
                                 {"nodes", kPaperNodes},
                                 {"deformation", kPaperDeformation},
                                 {"interaction", kPaperInteraction},
                                 {"total", kPaperTotal}}}};
  print_json(result);
}

/// What a haptic loop of 1 kHz has for a cycle.
PlotLimit cycle_limit() {
  return {"a cycle of the 1 kHz loop: 1 ms", 1e6 * sim::kCyclePeriod};
}

/// Time over the number of nodes of all bodies, under the last model measured.
Plot over_nodes(const std::vector<SceneCost>& costs) {
  Plot plot{.title = fmt::format("One haptic cycle, contact model {}, bodies touching",
                                 costs.front().models.back().cycle.law),
            .note = fmt::format(
                "median of all poses; shaded: up to the time that 99.9 % of the cycles keep; {}; {}",
                base::describe_machine(), versions()),
            .x_label = "nodes of all bodies",
            .y_label = "time [µs]",
            .log_x = true,
            .log_y = true,
            .panels = {{.series = {{.name = "total, shaded to 99.9 %"},
                                   {.name = "interaction"},
                                   {.name = "deformation"},
                                   {.name = "limit: compliance read once"}}}},
            .limits = {cycle_limit()}};
  std::vector<PlotSeries>& series = plot.panels.front().series;
  for (const SceneCost& scene : costs) {
    const sim::CycleCost& cost = scene.models.back().cycle;
    const double times[] = {cost.total.median, cost.interaction.median, cost.deformation.median, cost.limit};
    for (std::size_t i = 0; i < series.size(); ++i) {
      series[i].x.push_back(scene.nodes);
      series[i].y.push_back(times[i]);
    }
    series.front().high.push_back(cost.total.p999);
  }
  return plot;
}

/// One scene: time over the depth of the press, one curve a model.
Plot over_depth(const SceneCost& scene) {
  Plot plot{.title = fmt::format("One haptic cycle: {}, {} nodes", scene.scene, scene.nodes),
            .note = fmt::format(
                "median at each depth; shaded: up to the time that 99.9 % of the cycles keep; {}; {}",
                base::describe_machine(), versions()),
            .x_label = "depth [mm]",
            .y_label = "time [µs]",
            .log_y = true,
            .panels = {{}},
            .limits = {cycle_limit()}};
  for (const ModelCost& model : scene.models) {
    const sim::CycleCost& cost = model.cycle;
    PlotSeries series{.name = std::string(cost.law), .y = cost.depth_medians, .high = cost.depth_p999};
    for (const double depth : cost.depths) series.x.push_back(1e3 * depth);
    plot.panels.front().series.push_back(std::move(series));
  }
  return plot;
}

/// Where a contact model may stop early: the picture of time against bound, beside the other.
void draw_tolerances(const std::vector<SceneCost>& costs, const std::string& plot) {
  std::vector<Tolerances> all;
  for (const SceneCost& scene : costs)
    for (const ModelCost& model : scene.models)
      if (!model.tolerances.empty())
        all.push_back({scene.scene, std::string(model.cycle.law), model.tolerances});
  if (all.empty()) return;
  const std::filesystem::path file = tolerance_plot_file(plot);
  draw_plot(over_bound(all, fmt::format("{}; {}", base::describe_machine(), versions())), file);
  fmt::print(stderr, "wrote {}\n", file.string());
}

void run_cost(const CostOptions& options) {
  if (!options.plot.empty()) check_plot_file(options.plot);
  sim::ComplianceCache cache = user_cache();
  std::vector<SceneCost> costs;
  for (const std::string& file : options.scenes) costs.push_back(measure(options, file, cache));
  if (options.format == "json")
    print_costs(costs);
  else
    print_text(costs);
  if (options.plot.empty()) return;
  draw_plot(costs.size() == 1 ? over_depth(costs.front()) : over_nodes(costs), options.plot);
  fmt::print(stderr, "wrote {}\n", options.plot);
  draw_tolerances(costs, options.plot);
}

void add_cost(CLI::App& command) {
  auto options = std::make_shared<CostOptions>();
  command.add_option("scenes", options->scenes, "Scene files (TOML), one or several")->required();
  command.add_option(
      "--model", options->common.model,
      fmt::format("Only this contact model: {} (default: each)", sim::choice_of_contact_models()));
  command
      .add_option("--set", options->common.set,
                  "Replace an entry of every scene, e.g. bodies.prostate.young_modulus=\"5 MPa\"")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--depth", options->depth,
                     "How deep, with its unit (default: the probe's in the scene)");
  command.add_option(
      "--plot", options->plot,
      "Write a plot, .svg or .png: time over nodes for several scenes, over depth for one; beside the "
      "1 ms that the haptic loop has; and, where a contact model may stop early, FILE-tolerance: time over the "
      "bound of the force's error");
  add_format(command, options->format);
  command.footer(
      "Deformation is the body moved by the probes alone; interaction is detection and contact; the limit is "
      "the\n"
      "time to read once the compliance that the final contacts need. Measure on a quiet machine.\n"
      "A contact model that bounds its error is timed as well where it may stop early (contact.tolerance).\n"
      "Example:\n  palpate cost data/scenes/sphere-on-cube-*.toml --model kuroda --plot cost.svg");
  command.callback([options] { run_cost(*options); });
}

}  // namespace

const Command cost_command{.name = "cost",
                           .summary = "What accuracy costs in time: a cycle of the haptic loop",
                           .heading = "Touch",
                           .add = add_cost};

}  // namespace palpate::app
