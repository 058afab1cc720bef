#include "tests/extending/softening/softening.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/text/toml_reader.hpp"

namespace palpate::sim {
namespace {

std::vector<double> read(base::TomlReader& body, std::string_view key) {
  const double share = body.required_number(key);
  if (!(share > 0.0 && share < 1.0))
    body.refuse(key, fmt::format("found {}, accepted: a share between 0 and 1", share));
  return {share};
}

constexpr std::array kKeys{EffectKey{"bodies", "softening", "softening", read}};

EffectState state(const Scene& scene) {
  for (const BodySpec& body : scene.bodies)
    if (body.present && body.effects.contains("softening"))
      return {true, fmt::format("bodies.{}.softening", body.name)};
  return {false, "no softening of a body"};
}

void fill(const Scene& scene, Model& model) {
  for (const BodySpec& spec : scene.bodies) {
    const auto share = spec.effects.find("softening");
    if (!spec.present || share == spec.effects.end()) continue;
    Body& body = *std::ranges::find(model.bodies, spec.name, &Body::name);
    const double left = 1.0 - share->second.front();
    body.young_modulus *= left;
    for (Material& material : body.materials) material.young_modulus *= left;
  }
}

}  // namespace

constinit const Effect kSoftening{.name = "softening", .keys = kKeys, .state = state, .fill = fill};

}  // namespace palpate::sim
