#include "app/commands/render/render.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include "app/command_line/input_kind.hpp"
#include "app/command_line/scene_options.hpp"
#include "app/command_line/stimulus_options.hpp"
#include "app/command_line/user_cache.hpp"
#include "app/commands/render/view_option.hpp"
#include "base/files/atomic_file.hpp"
#include "base/files/folder_of.hpp"
#include "sim/compile/compile.hpp"
#include "sim/cycle/depth_warnings.hpp"
#include "sim/cycle/press.hpp"
#include "sim/view/annotate.hpp"
#include "sim/view/cut.hpp"
#include "sim/view/picture_of.hpp"
#include "sim/view/renderer.hpp"
#include "sim/view/scale_bar.hpp"
#include "trials/protocol/stimuli.hpp"

namespace palpate::app {
namespace {

struct RenderOptions {
  SceneOptions scene{};
  StimulusOptions stimulus{};
  std::filesystem::path out;
  std::string depth = "0 mm";
  std::string view = "across";
  std::string colour = "none";
  bool cut = false;
  int width = 960;
  int height = 720;
};

/// Loads of the cycle that holds every probe where it is.
sim::Loads pressed(const sim::Model& model, sim::ProbeDisplacements probes) {
  sim::Simulation simulation(model);
  if (!sim::solved(simulation.step(probes, sim::kCyclePeriod).solve.stop))
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

std::optional<sim::Field> parse_colour(const std::string& colour) {
  if (colour == "displacement") return sim::Field::Displacement;
  if (colour == "stress") return sim::Field::Stress;
  return std::nullopt;
}

/// Width that is left for the bodies. Throws std::invalid_argument where the legend would leave too little.
int drawn_width(const RenderOptions& options, bool legend) {
  const int width = options.width - (legend ? sim::legend_width(options.height) : 0);
  if (legend && width < sim::legend_width(options.height))
    throw std::invalid_argument(fmt::format(
        "--width {}: its legend leaves too little of the picture; accepted with --color: {} or more",
        options.width, 2 * sim::legend_width(options.height)));
  return width;
}

void run_render(const RenderOptions& options) {
  if (options.out.extension() != ".png")
    throw std::invalid_argument(
        fmt::format("--out {}: accepted: a file name that ends in .png", options.out.string()));
  const double depth = parse_depth(options.depth);
  base::require_folder_of(options.out);
  const std::optional<sim::ViewPoint> view = parse_view(options.view);
  const std::optional<sim::Field> field = parse_colour(options.colour);
  const int width = drawn_width(options, field.has_value());
  const sim::Model model = model_of(options);
  const std::vector<sim::ProbeDisplacement> probes = sim::displaced_by(model, depth);
  const sim::Loads loads = pressed(model, probes);
  for (const std::string& warning : sim::depth_warnings(model, depth, loads))
    fmt::print(stderr, "warning: {}\n", warning);
  const sim::Stage stage = sim::set_stage(model, static_cast<double>(width) / options.height, view);
  sim::Picture picture = sim::picture_of(model, stage, loads, probes);
  std::optional<sim::Legend> legend;
  if (field || options.cut) {
    const std::vector<sim::WholeBody> bodies = sim::whole_bodies(model, loads);
    if (options.cut) sim::cut_open(picture, model, bodies);
    if (field) legend = sim::paint(picture, model, bodies, *field);
  }
  sim::Renderer renderer(width, options.height);
  const sim::Image image = sim::annotated(renderer.render(picture), picture, legend);
  base::write_atomically(options.out, sim::encode_png(image));
  fmt::print(stderr, "wrote {}: {}, contact model {}, depth {}; the bar is {} long{}\n", options.out.string(),
             model.scene, model.law->name, options.depth, sim::length_in_words(stage.scale_bar),
             legend ? fmt::format("; {} of what is seen {:.4g} to {:.4g} {}", legend->title, legend->least,
                                  legend->most, legend->unit)
                    : "");
}

void add_render(CLI::App& command) {
  auto options = std::make_shared<RenderOptions>();
  add_scene(command, options->scene);
  command.get_option("scene")->description("Scene, or protocol with --condition and --cell (TOML)");
  add_stimulus(command, options->stimulus);
  command.add_option("--out", options->out, "Picture to write, a PNG file")->required();
  command.add_option("--depth", options->depth, "How deep every probe presses, with its unit")
      ->capture_default_str();
  command
      .add_option(
          "--view", options->view,
          "From where: across (the press), front (from -y, z up), right (from +x), back, left, top, bottom, "
          "or AZIMUTH,ELEVATION in degrees, counted from the front to the right and upwards")
      ->capture_default_str();
  command
      .add_option("--color,--colour", options->colour,
                  "displacement (its magnitude) or stress (von Mises, of each tetrahedron), with a "
                  "legend and every body solid; or none")
      ->check(CLI::IsMember({"displacement", "stress", "none"}))
      ->capture_default_str();
  command.add_flag("--cut", options->cut,
                   "Open the bodies along the first probe's press: what lies before it is taken away");
  command.add_option("--width", options->width, "[pixel]")
      ->check(CLI::Range(16, 8192))
      ->capture_default_str();
  command.add_option("--height", options->height, "[pixel]")
      ->check(CLI::Range(16, 8192))
      ->capture_default_str();
  command.footer(
      "Example:\n  palpate render data/scenes/rectal-palpation.toml --depth \"5 mm\" --out pressed.png\n"
      "  palpate render data/scenes/rectal-palpation.toml --depth \"5 mm\" --color stress --cut --out stress.png\n"
      "  palpate render protocols/kuroda2003.toml --condition hard --cell kuroda --out hard.png");
  command.callback([options] { run_render(*options); });
}

}  // namespace

const Command render_command{.name = "render",
                             .summary = "Picture of a scene, pressed or at rest, drawn off screen",
                             .heading = "Touch",
                             .add = add_render};

}  // namespace palpate::app
