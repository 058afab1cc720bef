#include "sim/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "sim/scene/refuse_key.hpp"

namespace palpate::sim {
namespace {

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

std::string place_of(const Scene& scene, std::string_view key) {
  auto found = scene.lines.of_key.find(key);
  for (auto dot = key.rfind('.'); found == scene.lines.of_key.end() && dot != std::string_view::npos;
       dot = key.rfind('.')) {
    key = key.substr(0, dot);
    found = scene.lines.of_key.find(key);
  }
  const bool in_file = found != scene.lines.of_key.end() && found->second > 0;
  return in_file ? fmt::format("{}:{}", scene.file.string(), found->second) : scene.file.string();
}

void validate(const Scene& scene) {
  if (scene.bodies.empty()) refuse_key("bodies", "no body; accepted: one table [bodies.NAME] a body");
  if (scene.probes.empty()) refuse_key("probes", "no probe; accepted: one table [probes.NAME] a probe");
  validate_touch(scene);
  for (const ProbeSpec& probe : scene.probes) {
    const std::string key = "probes." + probe.name;
    const BodySpec* body = find_body(scene, probe.body);
    if (!body)
      refuse_key(key + ".body",
                 fmt::format("\"{}\" is no body of this scene; accepted: {}", probe.body, body_names(scene)));
    if (!body->present) refuse_key(key + ".body", fmt::format("\"{}\" is not present", probe.body));
  }
}

}  // namespace palpate::sim
