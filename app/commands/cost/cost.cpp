#include "app/commands/cost/cost.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/command_line/interrupt.hpp"
#include "app/command_line/output.hpp"
#include "app/command_line/plot.hpp"
#include "app/command_line/progress.hpp"
#include "app/command_line/scene_options.hpp"
#include "app/command_line/user_cache.hpp"
#include "app/commands/cost/band_from.hpp"
#include "app/commands/cost/cycle_times.hpp"
#include "app/commands/cost/sweep.hpp"
#include "app/commands/cost/sweep_output.hpp"
#include "app/commands/cost/sweep_state.hpp"
#include "base/machine/machine.hpp"
#include "base/text/quantity.hpp"
#include "sim/compile/compile.hpp"
#include "sim/contact/laws.hpp"

namespace palpate::app {
namespace {

// Force: a just noticeable difference of roughly 7 % [Pang1991]; the upper end is our allowance for people who are not
// trained.
constexpr sim::Band kForceBand{.lower = 0.07, .upper = 0.10};
constexpr const char* kForceBandSource =
    "Pang, Tan and Durlach 1991 (Perception & Psychophysics 49, 531-540): roughly 7 % of the force; up to 10 % for those "
    "who are not trained (our allowance)";

struct CostOptions {
  std::vector<std::string> scenes;
  SceneOptions common{};  // of all scenes; its file is not used
  std::string depth;
  std::string plot;
  std::string format;
  std::vector<std::string> band;
  std::string band_from;
  double seconds = 1.0;
  bool times_only = false;
};

/// What is measured of one scene.
struct Costs {
  std::vector<SceneCost> times;
  std::optional<Sweep> sweep;  // of one scene alone
};

double depth_of(const CostOptions& options, const sim::Scene& scene) {
  const double depth = options.depth.empty() ? scene.probes.front().depth : parse_depth(options.depth);
  if (!(depth > 0.0)) throw std::invalid_argument(fmt::format("--depth {}: accepted: > 0", options.depth));
  return depth;
}

void take_band(const CostOptions& options, SweepPlan& plan) {
  plan.band = kForceBand;
  plan.band_source = kForceBandSource;
  if (!options.band_from.empty()) {
    const StudyBand measured = band_from(options.band_from);
    plan.band = measured.band;
    plan.band_source = measured.source;
  }
  if (options.band.empty()) return;
  const auto share = [&](std::size_t i) {
    try {
      return base::parse_quantity(options.band[i], base::Dimension::Fraction);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("--band: {}", error.what()));
    }
  };
  plan.band = {share(0), share(1)};
  plan.band_source = "--band";
  if (!(plan.band.lower > 0.0 && plan.band.lower <= plan.band.upper))
    throw std::invalid_argument(
        fmt::format("--band {} {}: accepted: two parts of the force, above 0, the smaller first",
                    options.band[0], options.band[1]));
}

Sweep sweep_of(const CostOptions& options, const sim::Scene& scene) {
  SweepPlan plan{
      .depth = depth_of(options, scene), .seconds = options.seconds, .model = options.common.model};
  take_band(options, plan);
  const SweepState state(scene, options.common.set, plan, base::describe_machine() + versions());
  std::vector<sim::VariantResult> finished = state.load();
  if (!finished.empty())
    fmt::print(stderr, "going on with a sweep that was interrupted after {} variants\n", finished.size());
  catch_interrupts();
  ProgressBar bar("variants");
  Sweep sweep = run_sweep(scene, plan, std::move(finished),
                          [&](const std::vector<sim::VariantResult>& done, std::size_t all) {
                            bar.show(static_cast<int>(done.size()), static_cast<int>(all));
                            state.save(done);
                            if (interrupted()) throw Interrupted();
                          });
  state.remove();
  return sweep;
}

Costs measure(const CostOptions& options) {
  sim::ComplianceCache cache = user_cache();
  Costs costs;
  for (const std::string& file : options.scenes) {
    SceneOptions options_of_scene = options.common;
    options_of_scene.file = file;
    const sim::Scene scene = load_scene(options_of_scene);
    costs.times.push_back(
        measure_cycle_times(sim::compile(scene, cache), depth_of(options, scene), options.common.model));
    if (options.scenes.size() == 1 && !options.times_only) costs.sweep = sweep_of(options, scene);
  }
  return costs;
}

void print(const CostOptions& options, const Costs& costs) {
  if (options.format == "csv") {
    fmt::print("{}", sweep_csv(*costs.sweep, base::describe_machine(), versions()));
    return;
  }
  if (options.format == "json") {
    nlohmann::ordered_json result = cycle_times_json(costs.times);
    if (costs.sweep) result.update(sweep_json(*costs.sweep));
    print_json(result);
    return;
  }
  print_cycle_times(costs.times);
  if (costs.sweep) fmt::print("{}", sweep_text(*costs.sweep));
}

/// "cost-depth.svg" beside "cost.svg".
std::filesystem::path beside(const std::filesystem::path& plot, const std::string& what) {
  return plot.parent_path() / (plot.stem().string() + "-" + what + plot.extension().string());
}

void draw(const CostOptions& options, const Costs& costs) {
  const std::filesystem::path file = options.plot;
  const std::string note = fmt::format("{}; {}", base::describe_machine(), versions());
  const auto write = [](const Plot& plot, const std::filesystem::path& to) {
    draw_plot(plot, to);
    fmt::print(stderr, "wrote {}\n", to.string());
  };
  if (costs.sweep) {
    write(work_precision(*costs.sweep, note), file);
    write(over_depth(costs.times.front()), beside(file, "depth"));
    if (sim::has_mesh_limit(costs.sweep->scene) && sim::meshes_of(costs.sweep->scene) > 1)
      write(over_family(*costs.sweep, note), beside(file, "nodes"));
  } else {
    write(costs.times.size() == 1 ? over_depth(costs.times.front()) : over_nodes(costs.times), file);
  }
  draw_tolerances(costs.times, options.plot);
}

void run_cost(const CostOptions& options) {
  if (!options.plot.empty()) check_plot_file(options.plot);
  if (options.format == "csv" && (options.scenes.size() > 1 || options.times_only))
    throw std::invalid_argument(
        "--format csv: is for the variants of one scene; accepted: one scene without --times-only");
  const Costs costs = measure(options);
  print(options, costs);
  if (!options.plot.empty()) draw(options, costs);
}

void add_cost(CLI::App& command) {
  auto options = std::make_shared<CostOptions>();
  command.add_option("scenes", options->scenes, "Scene files (TOML), one or several")->required();
  command.add_option("--model", options->common.model,
                     fmt::format("Only this contact model, beside exact: {} (default: each)",
                                 sim::choice_of_contact_models()));
  command
      .add_option("--set", options->common.set,
                  "Replace an entry of every scene, e.g. bodies.prostate.young_modulus=\"5 MPa\"")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--depth", options->depth,
                     "How deep, with its unit (default: the probe's in the scene)");
  command
      .add_option("--band", options->band,
                  "What a finger tells apart, as two parts of the force (default: \"7 %\" \"10 %\")")
      ->expected(2)
      ->type_name("LOWER UPPER");
  command.add_option(
      "--band-from", options->band_from,
      "Take that from a study file: what its examinees told apart (protocols/feel-the-difference.toml)");
  command.add_option("--seconds", options->seconds, "How long each variant is timed, about")
      ->check(CLI::Range(0.01, 3600.0))
      ->capture_default_str();
  command.add_flag("--times-only", options->times_only,
                   "Only the times of the scene as it is: no variants, no errors");
  command.add_option(
      "--plot", options->plot,
      "Write pictures, .svg or .png: of one scene FILE (time over error), FILE-depth, FILE-nodes (time over "
      "nodes) and FILE-tolerance; of several FILE (time over nodes)");
  command.add_option("--format", options->format, "What to print the result as")
      ->check(CLI::IsMember({"text", "json", "csv"}))
      ->default_val("text");
  command.footer(
      "Of one scene all variants are compared: contact models, where exact may stop early, in single precision,\n"
      "finer meshes (bodies.NAME.refinements) and finer insides; errors are those of the force against the limit\n"
      "of ever finer meshes. A sweep that is interrupted goes on when it is asked for again.\n"
      "Deformation is the body moved by the probes alone; interaction is detection and contact; the limit is the\n"
      "time to read once the compliance that the final contacts need. Measure on a quiet machine.\n"
      "Examples:\n  palpate cost data/scenes/rectal-palpation-pad.toml --plot cost.svg\n"
      "  palpate cost data/scenes/sphere-on-cube-*.toml --model kuroda --plot nodes.svg");
  command.callback([options] { run_cost(*options); });
}

}  // namespace

const Command cost_command{.name = "cost",
                           .summary = "What accuracy costs in time: a cycle of the haptic loop",
                           .heading = "Touch",
                           .add = add_cost};

}  // namespace palpate::app
