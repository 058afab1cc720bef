#include "app/command_line/scene_options.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "base/text/quantity.hpp"
#include "sim/contact/laws.hpp"

namespace palpate::app {

void add_scene(CLI::App& command, SceneOptions& options) {
  command.add_option("scene", options.file, "Scene file (TOML)")->required();
  command.add_option(
      "--model", options.model,
      fmt::format("Contact model: {} (default: the scene's)", sim::choice_of_contact_models()));
  command
      .add_option("--set", options.set, "Replace an entry of the scene, e.g. bodies.prostate.present=false")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

sim::Scene load_scene(const SceneOptions& options) {
  std::vector<sim::Override> overrides;
  for (const std::string& entry : options.set) {
    const auto equals = entry.find('=');
    if (equals == std::string::npos)
      throw std::invalid_argument(
          fmt::format("--set {}: accepted: KEY=VALUE, e.g. contact.model={}", entry, sim::kNoContact));
    overrides.push_back({entry.substr(0, equals), entry.substr(equals + 1)});
  }
  if (!options.model.empty()) overrides.push_back({"contact.model", options.model});
  return sim::load_scene(options.file, overrides);
}

double parse_depth(const std::string& depth) {
  double metres = 0.0;
  try {
    metres = base::parse_quantity(depth, base::Dimension::Length);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("--depth: {}", error.what()));
  }
  if (metres < 0.0) throw std::invalid_argument(fmt::format("--depth {}: accepted: 0 or more", depth));
  return metres;
}

}  // namespace palpate::app
