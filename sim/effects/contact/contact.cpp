#include "sim/effects/contact/contact.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace palpate::sim {
namespace {

bool is_present(const Scene& scene, const std::string& name) {
  return std::ranges::any_of(scene.bodies,
                             [&](const BodySpec& body) { return body.name == name && body.present; });
}

EffectState state_of_contact(const Scene& scene) {
  if (scene.contact.touch.empty()) return {false, "no pair of bodies in contact.touch"};
  if (scene.contact.model == kNoContact) return {false, fmt::format("contact.model = \"{}\"", kNoContact)};
  std::string pairs;
  for (const auto& pair : scene.contact.touch)
    if (is_present(scene, pair[0]) && is_present(scene, pair[1]))
      pairs += fmt::format("{}{} and {}", pairs.empty() ? "" : ", ", pair[0], pair[1]);
  if (pairs.empty()) return {false, "of each pair in contact.touch one body is not present"};
  return {true, fmt::format("contact.model = \"{}\" between {}", scene.contact.model, pairs),
          "contact.model"};
}

}  // namespace

constinit const Effect kContact{.name = "contact", .state = state_of_contact, .without = without_contact};

}  // namespace palpate::sim
