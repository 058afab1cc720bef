#pragma once

#include <span>
#include <string>
#include <string_view>

#include "sim/model/model.hpp"
#include "sim/scene/accepted.hpp"
#include "sim/scene/scene.hpp"

namespace palpate::sim {

/// Whether a scene calls for an effect, and why.
struct EffectState {
  bool on = false;
  std::string reason{};  // a clause that names the key of the scene
};

/// Physics that a scene may call for.
struct Effect {
  std::string_view name{};                       // as `check` lists it, which is also what its cost is called
  std::span<const LaterKey> later{};             // keys that call for it and that this version refuses
  std::span<const std::string_view> excludes{};  // names of effects that it cannot be combined with

  EffectState (*state)(const Scene& scene) = nullptr;

  /// The same model without this effect: its cost is what a cycle takes less.
  Model (*without)(Model model) = nullptr;
};

}  // namespace palpate::sim
