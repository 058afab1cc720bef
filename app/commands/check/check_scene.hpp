#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "app/command_line/scene_options.hpp"
#include "sim/mesh/quality.hpp"
#include "sim/model/effect.hpp"

namespace palpate::app {

struct BodyCheck {
  std::string name;
  sim::MeshQuality quality{};
  std::size_t fixed = 0, can_collide = 0;
};

struct EffectCheck {
  std::string_view name;
  sim::EffectState state{};
  double cycle_us = 0.0;  // what it adds to a cycle
};

struct SceneCheck {
  std::string name;
  std::vector<BodyCheck> bodies{};
  std::vector<EffectCheck> effects{};
  double deformation_us = 0.0;  // a cycle without any effect
};

/// Compiles and presses the scene, measures its meshes, and times what each effect adds to a cycle.
SceneCheck check_scene(const SceneOptions& input);

void print_text(const SceneCheck& check);
nlohmann::ordered_json to_json(const SceneCheck& check);

}  // namespace palpate::app
