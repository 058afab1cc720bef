#pragma once

#include <string>
#include <vector>

#include "sim/scene/scene.hpp"

namespace palpate::sim {

/// Physics that a scene may call for, and whether this one does.
struct Effect {
  std::string name;
  bool on = false;
  std::string reason;  // a clause that names the key of the scene
};

/// Every effect that the design knows, in the order of the slots of a compiled scene.
std::vector<Effect> effects_of(const Scene& scene);

}  // namespace palpate::sim
