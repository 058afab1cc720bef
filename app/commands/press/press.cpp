#include "app/commands/press/press.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>

#include "app/command_line/input_kind.hpp"
#include "app/command_line/output.hpp"
#include "app/command_line/plot.hpp"
#include "app/command_line/scene_options.hpp"
#include "app/command_line/stimulus_options.hpp"
#include "app/command_line/user_cache.hpp"
#include "app/commands/press/press_output.hpp"
#include "app/commands/press/press_path.hpp"
#include "app/commands/press/press_plot.hpp"
#include "app/commands/press/press_state.hpp"
#include "app/commands/press/press_study.hpp"
#include "app/study/simulation.hpp"
#include "base/files/folder_of.hpp"
#include "sim/compile/compile.hpp"
#include "sim/cycle/depth_warnings.hpp"
#include "sim/cycle/press.hpp"
#include "sim/cycle/stroke.hpp"

namespace palpate::app {
namespace {

struct PressOptions {
  SceneOptions scene{};
  StimulusOptions stimulus{};
  std::string depth;
  int steps = 10;
  std::string path;
  std::string save;
  std::string plot;
  std::filesystem::path observer;
  std::string format;
};

/// Once for each sentence, however many conditions it is true of.
void warn_of_depth(const sim::Model& model, const sim::Press& press, std::set<std::string>& told) {
  for (const std::string& warning : sim::depth_warnings(model, press.curve.back().depth, press.loads))
    if (told.insert(warning).second) fmt::print(stderr, "warning: {}\n", warning);
}

void press_scene(const PressOptions& options, std::optional<double> depth) {
  sim::ComplianceCache cache = user_cache();
  const sim::Model model = sim::compile(load_scene(options.scene), cache);
  const sim::Press press = sim::press(model, depth.value_or(model.probes.front().depth), options.steps);
  sim::require_solved(press);
  std::set<std::string> told;
  warn_of_depth(model, press, told);
  if (options.format == "json")
    print_json(press_json(model, press));
  else
    fmt::print("{}", press_text(model, press));
  if (!options.save.empty()) save_state(model, press.loads, options.save);
  if (options.plot.empty()) return;
  draw_plot(press_plot(model, press), options.plot);
  fmt::print(stderr, "wrote {}\n", options.plot);
}

void stroke_scene(const PressOptions& options) {
  sim::ComplianceCache cache = user_cache();
  sim::Scene scene = load_scene(options.scene);
  let_reach(scene, options.path);
  const sim::Model model = sim::compile(scene, cache);
  const sim::Stroke stroke = sim::stroke(model, read_stroke(model, options.path));
  sim::require_solved(stroke);
  for (const std::string& warning : stroke_warnings(model, stroke))
    fmt::print(stderr, "warning: {}\n", warning);
  if (options.format == "json")
    print_json(stroke_json(model, stroke));
  else
    fmt::print("{}", stroke_text(model, stroke));
  if (!options.save.empty()) save_state(model, stroke.loads, options.save);
  if (options.plot.empty()) return;
  draw_plot(stroke_plot(model, stroke), options.plot);
  fmt::print(stderr, "wrote {}\n", options.plot);
}

void press_protocol(const PressOptions& options, std::optional<double> depth) {
  sim::ComplianceCache cache = user_cache();
  const trials::Protocol protocol = trials::load_protocol(options.scene.file);
  const trials::ObserverParameters people =
      trials::load_observer(options.observer.empty() ? default_observer() : options.observer);
  std::vector<trials::Stimulus> chosen = chosen_stimuli(protocol, options.stimulus);
  if (!options.save.empty()) chosen = {only_stimulus(protocol, options.stimulus, "--save")};
  const std::vector<PressedStimulus> pressed = press_study(protocol, chosen, depth, options.steps, cache);
  std::set<std::string> told;
  for (const PressedStimulus& stimulus : pressed) warn_of_depth(stimulus.model, stimulus.press, told);
  if (options.format == "json")
    print_json(study_press_json(protocol, pressed));
  else
    fmt::print("{}", study_press_text(protocol, pressed));
  if (!options.save.empty()) save_state(pressed.front().model, pressed.front().press.loads, options.save);
  if (options.plot.empty()) return;
  draw_plot(study_press_plot(protocol, pressed, people), options.plot);
  fmt::print(stderr, "wrote {}\n", options.plot);
}

void run_press(const PressOptions& options) {
  if (!options.plot.empty()) check_plot_file(options.plot);
  std::optional<double> depth;
  if (!options.depth.empty()) depth = parse_depth(options.depth);
  if (depth && !(*depth > 0.0))
    throw std::invalid_argument(fmt::format("--depth {}: accepted: > 0", options.depth));
  if (!options.save.empty()) base::require_folder_of(options.save);
  if (input_kind(options.scene) == InputKind::Protocol) {
    if (!options.path.empty())
      throw std::invalid_argument(fmt::format("--path {}: {} is a protocol; accepted: with a scene",
                                              options.path, options.scene.file));
    return press_protocol(options, depth);
  }
  refuse_choice(options.stimulus, options.scene.file);
  if (!options.observer.empty())
    throw std::invalid_argument(fmt::format("--observer {}: {} is a scene; accepted: with a protocol",
                                            options.observer.string(), options.scene.file));
  if (options.path.empty()) return press_scene(options, depth);
  stroke_scene(options);
}

void add_press(CLI::App& command) {
  auto options = std::make_shared<PressOptions>();
  add_scene(command, options->scene);
  command.get_option("scene")->description("Scene, or protocol: each of its conditions in each cell (TOML)");
  add_stimulus(command, options->stimulus);
  auto* depth = command.add_option("--depth", options->depth,
                                   "How deep, with its unit (default: the probe's depth in the scene)");
  auto* steps = command.add_option("--steps", options->steps, "Equal steps from the surface to the depth")
                    ->check(CLI::Range(1, 1000000))
                    ->capture_default_str();
  command
      .add_option(
          "--path", options->path,
          "In place of a press, take the probes of a scene along a path (CSV): column time_s and, for "
          "each probe NAME, NAME.x_m, NAME.y_m, NAME.z_m, its displacement from where the scene puts it "
          "(and NAME.rx_rad, NAME.ry_rad, NAME.rz_rad, a rotation vector, of kinds that turn). Each row "
          "is one cycle; nothing is put between rows. A probe without columns stays at rest")
      ->excludes(depth)
      ->excludes(steps);
  command.add_option("--save", options->save,
                     "Write STATE.<body>.vtu with displacement, force and von Mises stress at the last step");
  command.add_option("--plot", options->plot,
                     "Write a plot of the force over the depth, or over the time of a path, .svg or .png");
  command.add_option(
      "--observer", options->observer,
      "Observer file (TOML) whose device's largest force the plot of a protocol shows (default: "
      "protocols/observers/default.toml)");
  add_format(command, options->format);
  command.footer(
      "Example:\n  palpate press data/scenes/rectal-palpation.toml --model kuroda --depth \"5 mm\" "
      "--set bodies.prostate.young_modulus=\"5 MPa\"\n"
      "  palpate press protocols/kuroda2003.toml --steps 100 --plot forces.svg\n"
      "  palpate press data/scenes/rectal-palpation.toml --path stroke.csv --plot stroke.svg");
  command.callback([options] { run_press(*options); });
}

}  // namespace

const Command press_command{
    .name = "press",
    .summary =
        "Force over depth of a press into a scene, or of each condition of a protocol; or along a path",
    .heading = "Touch",
    .add = add_press};

}  // namespace palpate::app
