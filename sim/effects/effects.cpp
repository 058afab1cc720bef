#include "sim/effects/effects.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace palpate::sim {
namespace {

bool is_present(const Scene& scene, const std::string& name) {
  return std::ranges::any_of(scene.bodies,
                             [&](const BodySpec& body) { return body.name == name && body.present; });
}

Effect contact(const Scene& scene) {
  if (scene.contact.touch.empty()) return {"contact", false, "no pair of bodies in contact.touch"};
  if (scene.contact.model == ContactModel::None) return {"contact", false, "contact.model = \"none\""};
  std::string pairs;
  for (const auto& pair : scene.contact.touch)
    if (is_present(scene, pair[0]) && is_present(scene, pair[1]))
      pairs += fmt::format("{}{} and {}", pairs.empty() ? "" : ", ", pair[0], pair[1]);
  if (pairs.empty()) return {"contact", false, "of each pair in contact.touch one body is not present"};
  return {"contact", true,
          fmt::format("contact.model = \"{}\" between {}", to_string(scene.contact.model), pairs)};
}

}  // namespace

std::vector<Effect> effects_of(const Scene& scene) {
  return {contact(scene),
          {"friction", false, "no contact.friction (not in this version)"},
          {"viscosity", false, "no relaxation of a body (not in this version)"},
          {"near-incompressibility", false, "no volumetric of a body (not in this version)"},
          {"large deformation", false, "no key calls for it (not in this version)"}};
}

}  // namespace palpate::sim
