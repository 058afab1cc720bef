#include "sim/cost/variant.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/contact/laws.hpp"
#include "sim/scene/refuse_key.hpp"

namespace palpate::sim {
namespace {

constexpr const char* kExactModel = "exact";
constexpr const char* kFrictionKey = "friction";  // of the contact table

// Of the force: from what nobody can feel to what anybody would.
constexpr double kTolerances[] = {0.001, 0.01, 0.05, 0.2};

// Cuts inside multiply the tetrahedra by eight: one where meshes are fine, two where the scene's own are taken.
int most_cuts(int mesh) {
  return mesh == 0 ? 2 : 1;
}

bool calls_for_friction(const Scene& scene) {
  return scene.contact.effects.contains(kFrictionKey);
}

/// Whether the contact's compliance is a constant of the scene.
bool compliance_stays(const Scene& scene) {
  return std::ranges::all_of(
      scene.probes, [](const ProbeSpec& probe) { return probe.reach == 0.0 && probe.kind != "fingertip"; });
}

}  // namespace

std::string name_of(const Variant& variant) {
  std::string name = variant.model;
  if (variant.friction) name += ", friction";
  if (variant.tolerance > 0.0) name += fmt::format(", may stop at {:g} %", 100 * variant.tolerance);
  if (variant.precision == Precision::Single) name += ", single precision";
  if (variant.interior > 0)
    name += fmt::format(", cut {} finer inside", variant.interior == 1 ? "once" : "twice");
  return name;
}

int meshes_of(const Scene& scene) {
  const BodySpec* first = nullptr;
  for (const BodySpec& body : scene.bodies) {
    if (body.refinements.empty()) continue;
    if (!first) first = &body;
    if (body.refinements.size() != first->refinements.size())
      refuse_key(
          fmt::format("bodies.{}.refinements", body.name),
          fmt::format("names {} meshes, and bodies.{}.refinements {}; accepted: as many of each body, since "
                      "they are taken together",
                      body.refinements.size(), first->name, first->refinements.size()));
  }
  return first ? 1 + static_cast<int>(first->refinements.size()) : 1;
}

bool has_mesh_limit(const Scene& scene) {
  return std::ranges::none_of(scene.probes, [](const ProbeSpec& probe) { return probe.kind == "point"; });
}

Variant exact_on(const Scene& scene, int mesh, int interior) {
  return {.model = kExactModel, .friction = calls_for_friction(scene), .mesh = mesh, .interior = interior};
}

Variant best_of(const Scene& scene, int mesh) {
  return exact_on(scene, mesh, 1);
}

std::vector<Variant> variants_of(const Scene& scene) {
  const bool limit = has_mesh_limit(scene);
  std::vector<Variant> all;
  for (int mesh = 0; mesh < (limit ? meshes_of(scene) : 1); ++mesh) {
    for (const ContactLaw* law : contact_laws())
      all.push_back({.model = std::string(law->name), .mesh = mesh});
    if (calls_for_friction(scene)) all.push_back(exact_on(scene, mesh));
    for (const double tolerance : kTolerances)
      all.push_back({.model = kExactModel, .tolerance = tolerance, .mesh = mesh});
    if (compliance_stays(scene))
      all.push_back({.model = kExactModel, .mesh = mesh, .precision = Precision::Single});
    for (int cuts = 1; limit && cuts <= most_cuts(mesh); ++cuts) all.push_back(exact_on(scene, mesh, cuts));
  }
  return all;
}

Scene with_variant(Scene scene, const Variant& variant) {
  for (BodySpec& body : scene.bodies) {
    if (variant.mesh > 0 && !body.refinements.empty())
      body.mesh = body.refinements[static_cast<std::size_t>(variant.mesh) - 1];
    body.interior += variant.interior;
  }
  scene.contact.model = variant.model;
  scene.contact.tolerance = variant.tolerance;
  scene.contact.precision = variant.precision;
  if (!variant.friction) scene.contact.effects.erase(kFrictionKey);
  return scene;
}

}  // namespace palpate::sim
