#include "tests/extending/softening/softening.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/text/toml_reader.hpp"

namespace palpate::sim {
namespace {

std::vector<double> read(base::TomlReader& body, std::string_view key) {
  return {body.number(key)};
}

constexpr std::array kKeys{
    EffectKey{.table = "bodies",
              .key = {.name = "softening",
                      .takes = base::takes_number({.least = 0.0, .most = 1.0, .open = true}),
                      .example = "0.2",
                      .absent = "the material as it is",
                      .meaning = "The share by which the body is softer than its material says."},
              .calls_for = "softening",
              .read = read}};

EffectState state(const Scene& scene) {
  for (const BodySpec& body : scene.bodies)
    if (body.present && body.effects.contains("softening"))
      return {true, fmt::format("bodies.{}.softening = {}", body.name, body.effects.at("softening").front()),
              fmt::format("bodies.{}.softening", body.name)};
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
