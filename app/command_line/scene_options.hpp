#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "sim/scene/scene.hpp"

namespace palpate::app {

/// What every command that works on a scene takes.
struct SceneOptions {
  std::string file;
  std::string model;             // replaces contact.model
  std::vector<std::string> set;  // KEY=VALUE, dotted keys
};

void add_scene(CLI::App& command, SceneOptions& options);

/// The scene with its replacements. Throws std::invalid_argument.
sim::Scene load_scene(const SceneOptions& options);

/// What --depth asks for [m], not below 0. Throws std::invalid_argument.
double parse_depth(const std::string& depth);

}  // namespace palpate::app
