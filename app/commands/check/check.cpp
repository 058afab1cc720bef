#include "app/commands/check/check.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/command_line/input_kind.hpp"
#include "app/command_line/output.hpp"
#include "app/command_line/scene_options.hpp"
#include "app/commands/check/check_protocol.hpp"
#include "app/commands/check/check_scene.hpp"
#include "app/commands/mesh/mesh_report.hpp"
#include "base/text/quantity.hpp"
#include "base/text/toml_reader.hpp"
#include "trials/observer/observer.hpp"

namespace palpate::app {
namespace {

struct CheckOptions {
  SceneOptions input{};
  std::string unit;
  std::string format;
};

template <typename Check>
void print(const Check& check, const std::string& format) {
  if (format == "json")
    print_json(to_json(check));
  else
    print_text(check);
}

void check_mesh(const CheckOptions& options) {
  if (options.unit.empty())
    throw std::invalid_argument(fmt::format(
        "{}: a mesh file does not name its unit; give --unit m, cm, mm or um", options.input.file));
  const MeshReport report = inspect_mesh(options.input.file, base::metres_per_unit(options.unit));
  if (options.format == "json")
    print_json(to_json(report));
  else
    fmt::print("{}", to_text(report));
}

/// Whether a file says what simulated examinees are like.
bool is_observer(const std::string& file) {
  return base::read_toml(file).contains("senses");
}

void check_observer(const CheckOptions& options) {
  const trials::ObserverParameters observer = trials::load_observer(options.input.file);
  if (options.format == "json")
    print_json(nlohmann::ordered_json::parse(trials::to_json(observer)));
  else
    fmt::print("{}: sound simulated examinees, right in 75 % where stiffness differs by {:g} %\n",
               observer.name, 100 * observer.weber_fraction.mean);
}

void run_check(const CheckOptions& options) {
  const std::string ending = std::filesystem::path(options.input.file).extension();
  if (ending == ".msh" || ending == ".vtu") return check_mesh(options);
  if (is_observer(options.input.file)) return check_observer(options);
  if (input_kind(options.input) == InputKind::Scene) return print(check_scene(options.input), options.format);
  print(check_protocol(options.input.file), options.format);
}

void add_check(CLI::App& command) {
  auto options = std::make_shared<CheckOptions>();
  add_scene(command, options->input);
  command.get_option("scene")->description("Protocol, scene or observer (TOML), or mesh (MSH, VTU)");
  command.add_option("--unit", options->unit, "Unit of a mesh file's coordinates: m, cm, mm or um");
  add_format(command, options->format);
  command.footer(
      "Examples:\n  palpate check protocols/kuroda2003.toml\n  palpate check "
      "data/scenes/rectal-palpation.toml\n"
      "  palpate check prostate.msh --unit mm");
  command.callback([options] { run_check(*options); });
}

}  // namespace

const Command check_command{.name = "check",
                            .summary = "Validates a protocol, a scene or a mesh, and says what it amounts to",
                            .heading = "Run a study",
                            .add = add_check};

}  // namespace palpate::app
