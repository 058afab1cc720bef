#pragma once

#include <span>
#include <string>
#include <string_view>

#include "sim/model/exclusion.hpp"
#include "sim/model/model.hpp"
#include "sim/scene/accepted.hpp"
#include "sim/scene/scene.hpp"

namespace palpate::sim {

/// Whether a scene calls for an effect, and why.
struct EffectState {
  bool on = false;
  std::string reason{};  // a clause that names the key of the scene: of what is on, with its value
  std::string key{};     // that calls for it, where it is on: "contact.model"
};

inline void fill_nothing(const Scene&, Model&) {}
inline Model unchanged(Model model) {
  return model;
}

/// Physics that a scene may call for.
struct Effect {
  std::string_view name{};                // as `check` lists it, which is also what its cost is called
  std::span<const EffectKey> keys{};      // of a scene, that call for it
  std::span<const Exclusion> excludes{};  // what a scene cannot call for beside it

  EffectState (*state)(const Scene& scene) = nullptr;

  /// Puts into a compiled model what the scene calls for. Called where the effect is on.
  void (*fill)(const Scene& scene, Model& model) = fill_nothing;

  /// The same model without what the effect does in a cycle: its cost is what a cycle takes less.
  Model (*without)(Model model) = unchanged;
};

}  // namespace palpate::sim
