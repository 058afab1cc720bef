#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "sim/model/effect.hpp"
#include "sim/model/model.hpp"
#include "sim/scene/scene.hpp"

namespace palpate::app {

struct EffectCheck {
  std::string_view name{};
  sim::EffectState state{};
  std::string place{};    // "scene.toml:31", of the key that calls for it; "--set" where no line does
  double cycle_us = 0.0;  // what it adds to a cycle: what one takes without it less; 0 where it is off
};

/// What presses: kinds differ in what they prescribe, which is part of every cycle.
struct ProbeCheck {
  std::string name{};
  std::string kind{};
  std::string place{};
  std::size_t nodes = 0;  // that it holds, or may touch
  bool touches = false;   // from outside: it holds none
};

/// What a scene calls for, and what that costs on this machine.
struct EffectsCheck {
  double deformation_us = 0.0;  // a cycle without any effect
  std::vector<EffectCheck> effects{};
  std::vector<ProbeCheck> probes{};
};

EffectsCheck check_effects(const sim::Scene& scene, const sim::Model& model);

std::string to_text(const EffectsCheck& check);
nlohmann::ordered_json effects_json(const EffectsCheck& check);
nlohmann::ordered_json probes_json(const EffectsCheck& check);

}  // namespace palpate::app
