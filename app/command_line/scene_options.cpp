#include "app/command_line/scene_options.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "base/text/quantity.hpp"
#include "base/text/toml_reader.hpp"
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

namespace {

/// A protocol in the place of a scene is told as such, with the scene that it names.
void refuse_protocol(const std::filesystem::path& file) {
  const toml::table content = base::read_toml(file);
  if (content.contains("bodies") || !content.contains("scene") || !content.contains("task")) return;
  const auto scene = content["scene"].value<std::string>();
  throw std::invalid_argument(
      fmt::format("{}: is a protocol, and a scene is needed{}", file.string(),
                  scene ? fmt::format("; accepted: {}, which it names",
                                      (file.parent_path() / *scene).lexically_normal().string())
                        : ""));
}

}  // namespace

sim::Scene load_scene(const SceneOptions& options) {
  refuse_protocol(options.file);
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
