#include "sim/compile/compile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/compile/body.hpp"
#include "sim/compile/combinations.hpp"
#include "sim/compile/overlap.hpp"
#include "sim/contact/exact/exact.hpp"
#include "sim/contact/laws.hpp"
#include "sim/effects/effects.hpp"
#include "sim/probe/kinds.hpp"
#include "sim/scene/refuse_key.hpp"

namespace palpate::sim {
namespace {

void add_body(const Scene& scene, const BodySpec& spec, ComplianceCache& cache, Model& model) {
  std::vector<const ProbeSpec*> specs;
  std::vector<int> places;
  for (int i = 0; i < std::ssize(scene.probes); ++i) {
    if (scene.probes[i].body != spec.name) continue;
    specs.push_back(&scene.probes[i]);
    places.push_back(i);
  }
  auto [body, probes] = compile_body(spec, specs, cache);
  for (Probe& probe : probes) probe.body = static_cast<int>(model.bodies.size());
  for (std::size_t i = 0; i < probes.size(); ++i) model.probes[places[i]] = std::move(probes[i]);
  body.probes = std::move(places);
  model.bodies.push_back(std::move(body));
}

void add_pair(const std::array<std::string, 2>& names, const std::string& nodes_of, Model& model) {
  const auto a = std::ranges::find(model.bodies, names[0], &Body::name);
  const auto b = std::ranges::find(model.bodies, names[1], &Body::name);
  if (a == model.bodies.end() || b == model.bodies.end()) return;  // one of them is not present
  refuse_overlap(*a, *b, model.overlap);
  TouchPair pair{{static_cast<int>(a - model.bodies.begin()), static_cast<int>(b - model.bodies.begin())}};
  if (std::ranges::find(names, nodes_of) != names.end())
    pair.meets = {names[0] == nodes_of, names[1] == nodes_of};
  model.pairs.push_back(pair);
}

/// Single precision is for a compliance that stays as it is.
void refuse_precision(const Model& model) {
  if (model.contact_precision == Precision::Single &&
      (model.law != &contact_law("exact") || !rows_stay(model)))
    refuse_key(
        "contact.precision",
        "single precision is for a compliance that is a constant of the scene, and here friction, a fingertip or "
        "a probe with a reach changes it from cycle to cycle; accepted: \"double\"");
}

void refuse_far_regions(const Model& model) {
  for (const Probe& probe : model.probes)
    if (probe.region && probe.region->carries && !model.law->follows_regions && !model.pairs.empty())
      refuse_key(
          fmt::format("probes.{}.reach", probe.name),
          fmt::format("the contact model {} does not find anew what touches where a region takes a body far; "
                      "accepted: the probe without reach, or contact.model = \"exact\"",
                      model.law->name));
}

Model compile_all(const Scene& scene, ComplianceCache& cache) {
  refuse_combinations(scene, effects(), probe_kinds());
  Model model{.scene = scene.name,
              .law = &contact_law(scene.contact.model),
              .contact_tolerance = scene.contact.tolerance,
              .contact_precision = scene.contact.precision,
              .reading = scene.contact.reading,
              .overlap = scene.contact.overlap};
  model.probes.resize(scene.probes.size());
  for (const BodySpec& spec : scene.bodies)
    if (spec.present) add_body(scene, spec, cache, model);
  for (const auto& names : scene.contact.touch) add_pair(names, scene.contact.nodes_of, model);
  fill_effects(scene, model);
  refuse_precision(model);
  refuse_far_regions(model);
  return model;
}

}  // namespace

Model compile(const Scene& scene, ComplianceCache& cache) {
  return with_place(scene, [&] { return compile_all(scene, cache); });
}

}  // namespace palpate::sim
