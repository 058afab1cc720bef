#include "app/commands/render/render.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "app/command_line/input_kind.hpp"
#include "app/command_line/scene_options.hpp"
#include "app/command_line/stimulus_options.hpp"
#include "app/command_line/user_cache.hpp"
#include "base/files/atomic_file.hpp"
#include "base/files/folder_of.hpp"
#include "sim/compile/compile.hpp"
#include "sim/cycle/press.hpp"
#include "sim/view/picture_of.hpp"
#include "sim/view/renderer.hpp"
#include "trials/protocol/stimuli.hpp"

namespace palpate::app {
namespace {

struct RenderOptions {
  SceneOptions scene{};
  StimulusOptions stimulus{};
  std::filesystem::path out;
  std::string depth = "0 mm";
  int width = 960;
  int height = 720;
};

/// Loads of the cycle that holds every probe where it is.
sim::Loads pressed(const sim::Model& model, sim::ProbeDisplacements probes) {
  sim::Simulation simulation(model);
  if (simulation.step(probes, sim::kCyclePeriod).solve.stop != sim::Stop::Converged)
    throw std::runtime_error(
        "the bodies' displacements could not be solved at this depth: no picture written");
  return simulation.loads();
}

sim::Model model_of(const RenderOptions& options) {
  sim::ComplianceCache cache = user_cache();
  if (input_kind(options.scene) == InputKind::Protocol) {
    const trials::Protocol protocol = trials::load_protocol(options.scene.file);
    return trials::compile_stimulus(protocol, only_stimulus(protocol, options.stimulus, "a picture"), cache);
  }
  refuse_choice(options.stimulus, options.scene.file);
  return sim::compile(load_scene(options.scene), cache);
}

void run_render(const RenderOptions& options) {
  if (options.out.extension() != ".png")
    throw std::invalid_argument(
        fmt::format("--out {}: accepted: a file name that ends in .png", options.out.string()));
  const double depth = parse_depth(options.depth);
  base::require_folder_of(options.out);
  const sim::Model model = model_of(options);
  const std::vector<sim::ProbeDisplacement> probes = sim::displaced_by(model, depth);
  const sim::Stage stage = sim::set_stage(model, static_cast<double>(options.width) / options.height);
  const sim::Picture picture = sim::picture_of(model, stage, pressed(model, probes), probes);
  sim::Renderer renderer(options.width, options.height);
  base::write_atomically(options.out, sim::encode_png(renderer.render(picture)));
  fmt::print(stderr, "wrote {}: {}, contact model {}, depth {}; the bar is {:g} mm long\n",
             options.out.string(), model.scene, model.law->name, options.depth, 1e3 * stage.scale_bar);
}

void add_render(CLI::App& command) {
  auto options = std::make_shared<RenderOptions>();
  add_scene(command, options->scene);
  command.get_option("scene")->description("Scene, or protocol with --condition and --cell (TOML)");
  add_stimulus(command, options->stimulus);
  command.add_option("--out", options->out, "Picture to write, a PNG file")->required();
  command.add_option("--depth", options->depth, "How deep every probe presses, with its unit")
      ->capture_default_str();
  command.add_option("--width", options->width, "[pixel]")
      ->check(CLI::Range(16, 8192))
      ->capture_default_str();
  command.add_option("--height", options->height, "[pixel]")
      ->check(CLI::Range(16, 8192))
      ->capture_default_str();
  command.footer(
      "Example:\n  palpate render data/scenes/rectal-palpation.toml --depth \"5 mm\" --out pressed.png\n"
      "  palpate render protocols/kuroda2003.toml --condition hard --cell kuroda --out hard.png");
  command.callback([options] { run_render(*options); });
}

}  // namespace

const Command render_command{.name = "render",
                             .summary = "Picture of a scene, pressed or at rest, drawn off screen",
                             .heading = "Touch",
                             .add = add_render};

}  // namespace palpate::app
