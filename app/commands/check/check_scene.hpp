#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/command_line/scene_options.hpp"
#include "app/commands/check/check_effects.hpp"
#include "sim/mesh/quality.hpp"

namespace palpate::app {

struct BodyCheck {
  std::string name;
  sim::MeshQuality quality{};
  std::size_t fixed = 0, can_collide = 0;
};

struct SceneCheck {
  std::string name;
  std::vector<BodyCheck> bodies{};
  EffectsCheck effects{};
};

/// Compiles and presses the scene, measures its meshes, and times what each effect adds to a cycle.
SceneCheck check_scene(const SceneOptions& input);

void print_text(const SceneCheck& check);
nlohmann::ordered_json to_json(const SceneCheck& check);

}  // namespace palpate::app
