#include "sim/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/scene/refuse_key.hpp"

namespace palpate::sim {
namespace {

void validate(const Material& material, const std::string& key) {
  if (!(material.young_modulus > 0.0) || !std::isfinite(material.young_modulus))
    refuse_key(key + ".young_modulus", fmt::format("found {} Pa, accepted: > 0", material.young_modulus));
  if (!(material.poisson_ratio > -1.0 && material.poisson_ratio < 0.5))
    refuse_key(key + ".poisson_ratio",
               fmt::format("found {}, accepted: greater than -1 and less than 0.5", material.poisson_ratio));
}

void validate(const BodySpec& body) {
  const std::string key = "bodies." + body.name;
  validate(body.material, key);
  for (const auto& [name, material] : body.regions)
    validate(material, fmt::format("{}.regions.{}", key, name));
  if (!(body.scale > 0.0) || !std::isfinite(body.scale))
    refuse_key(key + ".scale", fmt::format("found {}, accepted: > 0", body.scale));
}

const BodySpec* find_body(const Scene& scene, const std::string& name) {
  const auto found = std::ranges::find(scene.bodies, name, &BodySpec::name);
  return found == scene.bodies.end() ? nullptr : &*found;
}

std::string body_names(const Scene& scene) {
  std::string names;
  for (const BodySpec& body : scene.bodies) names += (names.empty() ? "" : ", ") + body.name;
  return names;
}

void validate_touch(const Scene& scene) {
  for (const auto& pair : scene.contact.touch) {
    for (const std::string& name : pair)
      if (!find_body(scene, name))
        refuse_key("contact.touch",
                   fmt::format("\"{}\" is no body of this scene; accepted: {}", name, body_names(scene)));
    if (pair[0] == pair[1])
      refuse_key("contact.touch",
                 fmt::format("\"{}\" touches itself; accepted: two different bodies", pair[0]));
    const auto same = [&](const auto& other) {
      return other == pair || (other[0] == pair[1] && other[1] == pair[0]);
    };
    if (std::ranges::count_if(scene.contact.touch, same) > 1)
      refuse_key("contact.touch",
                 fmt::format("names \"{}\" and \"{}\" twice; accepted: each pair once", pair[0], pair[1]));
  }
}

}  // namespace

void validate(const Scene& scene) {
  if (scene.bodies.empty()) refuse_key("bodies", "no body; accepted: one table [bodies.NAME] a body");
  if (scene.probes.empty()) refuse_key("probes", "no probe; accepted: one table [probes.NAME] a probe");
  for (const BodySpec& body : scene.bodies) validate(body);
  validate_touch(scene);
  for (const ProbeSpec& probe : scene.probes) {
    const std::string key = "probes." + probe.name;
    const BodySpec* body = find_body(scene, probe.body);
    if (!body)
      refuse_key(key + ".body",
                 fmt::format("\"{}\" is no body of this scene; accepted: {}", probe.body, body_names(scene)));
    if (!body->present) refuse_key(key + ".body", fmt::format("\"{}\" is not present", probe.body));
    if (!(probe.depth > 0.0))
      refuse_key(key + ".depth", fmt::format("found {} m, accepted: > 0", probe.depth));
  }
}

}  // namespace palpate::sim
