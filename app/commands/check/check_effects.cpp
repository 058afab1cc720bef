#include "app/commands/check/check_effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/text/counted.hpp"
#include "sim/cycle/press.hpp"
#include "sim/effects/effects.hpp"
#include "sim/model/probe_kind.hpp"
#include "sim/scene/refuse_key.hpp"

namespace palpate::app {
namespace {

/// Nodes that a probe holds, or may touch.
std::size_t nodes_of(const sim::Probe& probe) {
  if (probe.region) return probe.region->nodes.size();
  return probe.tip ? probe.tip->nodes.size() : probe.nodes.size();
}

/// Median time of a cycle [microseconds] while the probes go to and fro over the deepest fifth of their press, as a hand
/// does: a pose that is held lets a law find what it found before. Over cycles enough for a stable median.
double median_cycle_us(const sim::Model& model) {
  constexpr int kPoses = 20;
  sim::Simulation simulation(model);
  std::vector<std::vector<sim::ProbeDisplacement>> poses;
  for (int i = 0; i < kPoses; ++i) {
    const double share = 1.0 - 0.2 * std::abs(1.0 - 2.0 * i / kPoses);
    poses.push_back(sim::displaced_by(model, share * model.probes.front().depth));
  }
  std::vector<double> times;
  for (int i = 0; i < 2000; ++i) {
    const auto& probes = poses[static_cast<std::size_t>(i % kPoses)];
    const auto before = std::chrono::steady_clock::now();
    simulation.step(probes, sim::kCyclePeriod);
    times.push_back(
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - before).count());
  }
  std::ranges::nth_element(times, times.begin() + 1000);
  return times[1000];
}

/// Where a scene says it; a key that an override has put there has no line.
std::string place_of_call(const sim::Scene& scene, const std::string& key) {
  const auto line = scene.lines.of_key.find(key);
  return line != scene.lines.of_key.end() && line->second == 0 ? "--set" : sim::place_of(scene, key);
}

}  // namespace

EffectsCheck check_effects(const sim::Scene& scene, const sim::Model& model) {
  EffectsCheck check;
  const double whole = median_cycle_us(model);
  sim::Model bare = model;
  for (const sim::Effect* effect : sim::effects()) {
    EffectCheck found{.name = effect->name, .state = effect->state(scene)};
    if (found.state.on) {
      found.place = place_of_call(scene, found.state.key);
      if (effect->without != sim::unchanged) {  // else it does nothing in a cycle
        bare = effect->without(std::move(bare));
        found.cycle_us = std::max(0.0, whole - median_cycle_us(effect->without(model)));
      }
    }
    check.effects.push_back(std::move(found));
  }
  check.deformation_us = median_cycle_us(bare);
  for (const sim::Probe& probe : model.probes)
    check.probes.push_back({probe.name, std::string(probe.kind->keys.name),
                            place_of_call(scene, fmt::format("probes.{}.kind", probe.name)), nodes_of(probe),
                            probe.tip != nullptr});
  return check;
}

std::string to_text(const EffectsCheck& check) {
  std::string text = fmt::format("{:<27}{:<5}{:>13}  {}\n", "effects", "", "us a cycle", "what calls for it");
  const auto add = [&](std::string_view name, bool on, double cycle_us, const std::string& why) {
    text += fmt::format("  {:<25}{:<5}{:>13}  {}\n", name, on ? "on" : "off",
                        on ? fmt::format("{:.1f}", cycle_us) : "0", why);
  };
  add("linear elasticity", true, check.deformation_us, "every scene");
  for (const EffectCheck& effect : check.effects)
    add(effect.name, effect.state.on, effect.cycle_us,
        effect.state.on ? fmt::format("{} {}", effect.place, effect.state.reason)
                        : fmt::format("nothing calls for it: {}", effect.state.reason));
  text += "\nprobes\n";
  for (const ProbeCheck& probe : check.probes)
    text += fmt::format("  {}: a {}, which {} {}; {}\n", probe.name, probe.kind,
                        probe.touches ? "may touch" : "holds",
                        base::counted(static_cast<long>(probe.nodes), "node", "nodes"), probe.place);
  return text +
         "\nMedian times on this machine over the deepest fifth of a press: an effect's is what a cycle takes "
         "less without it.\nWhat is off has no code in the cycle, and is not timed.\n";
}

nlohmann::ordered_json effects_json(const EffectsCheck& check) {
  nlohmann::ordered_json effects = nlohmann::ordered_json::array();
  effects.push_back({{"effect", "linear elasticity"},
                     {"on", true},
                     {"why", "every scene"},
                     {"called_for_at", nullptr},
                     {"key", nullptr},
                     {"cycle_us", check.deformation_us},
                     {"measured", true}});
  for (const EffectCheck& effect : check.effects) {
    nlohmann::ordered_json place, key;
    if (effect.state.on) {
      place = effect.place;
      key = effect.state.key;
    }
    effects.push_back({{"effect", std::string(effect.name)},
                       {"on", effect.state.on},
                       {"why", effect.state.reason},
                       {"called_for_at", place},
                       {"key", key},
                       {"cycle_us", effect.cycle_us},
                       {"measured", effect.state.on}});
  }
  return effects;
}

nlohmann::ordered_json probes_json(const EffectsCheck& check) {
  nlohmann::ordered_json probes;
  for (const ProbeCheck& probe : check.probes)
    probes[probe.name] = {{"kind", probe.kind}, {"nodes", probe.nodes}, {"at", probe.place}};
  return probes;
}

}  // namespace palpate::app
