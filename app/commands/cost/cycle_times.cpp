#include "app/commands/cost/cycle_times.hpp"

#include <fmt/format.h>

#include "app/commands/cost/tolerances.hpp"
#include "base/machine/machine.hpp"
#include "sim/contact/laws.hpp"
#include "sim/cycle/simulation.hpp"

namespace palpate::app {

using nlohmann::ordered_json;

namespace {

// [Kuroda2003] sections 4 and 5.1, on one Pentium III of 933 MHz.
constexpr double kPaperDeformation = 1170.0, kPaperInteraction = 1620.0, kPaperTotal = 2880.0;  // [us]
constexpr int kPaperNodes = 642;                                                                // Table 1
constexpr const char* kPaperSource =
    "Kuroda et al. 2003, section 5.1, rectal palpation (Table 1), Pentium III 933 MHz";

// Of the force: from a solution to the end to what a hand would notice.
constexpr double kTolerances[] = {0.0, 0.001, 0.01, 0.05, 0.2};

}  // namespace

std::string versions() {
  return fmt::format("palpate {}, GCC {}", PALPATE_VERSION, __VERSION__);
}

SceneCost measure_cycle_times(const sim::Model& model, double depth, const std::string& only) {
  SceneCost cost{.scene = model.scene, .models = {}};
  for (const sim::Body& body : model.bodies) {
    cost.nodes += static_cast<int>(body.mesh->nodes.size());
    cost.touchable += static_cast<int>(body.rest.cols());
  }
  const sim::CycleSampling how{.depth = depth};
  for (const sim::ContactLaw* listed : sim::contact_laws()) {
    if (!only.empty() && listed->name != only) continue;
    const sim::ContactLaw& law =
        listed->name == model.law->name ? *model.law : *listed;  // with the scene's friction
    cost.models.push_back({.cycle = sim::measure_cycle(model, law, how),
                           .tolerances = sim::measure_tolerances(model, law, how, kTolerances)});
  }
  return cost;
}

namespace {

void print_row(const std::string& model, const std::string& contacts, const char* what,
               const sim::Percentiles& times) {
  fmt::print("{:<9} {:>8}  {:<12} {:>9.2f} {:>9.2f} {:>9.2f} {:>9.2f}\n", model, contacts, what, times.median,
             times.p99, times.p999, times.slowest);
}

}  // namespace

void print_cycle_times(const std::vector<SceneCost>& costs) {
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

namespace {

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

}  // namespace

ordered_json cycle_times_json(const std::vector<SceneCost>& costs) {
  ordered_json scenes = ordered_json::array();
  for (const SceneCost& scene : costs) {
    ordered_json models = ordered_json::array();
    for (const ModelCost& model : scene.models) models.push_back(to_json(model));
    scenes.push_back({{"scene", scene.scene},
                      {"nodes", scene.nodes},
                      {"touchable_nodes", scene.touchable},
                      {"models", models}});
  }
  return {{"units", {{"time", "us"}, {"depth", "m"}}},
          {"machine", base::describe_machine()},
          {"versions", versions()},
          {"scenes", scenes},
          {"published",
           {{"source", kPaperSource},
            {"nodes", kPaperNodes},
            {"deformation", kPaperDeformation},
            {"interaction", kPaperInteraction},
            {"total", kPaperTotal}}}};
}

namespace {

/// What a haptic loop of 1 kHz has for a cycle.
PlotLimit cycle_limit() {
  return {"a cycle of the 1 kHz loop: 1 ms", 1e6 * sim::kCyclePeriod};
}

}  // namespace

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

}  // namespace palpate::app
