#include "sim/effects/later/later.hpp"

#include <array>

namespace palpate::sim {
namespace {

EffectState no_friction(const Scene&) {
  return {false, "no contact.friction (not in this version)"};
}
EffectState no_viscosity(const Scene&) {
  return {false, "no relaxation of a body (not in this version)"};
}
EffectState no_near_incompressibility(const Scene&) {
  return {false, "no volumetric of a body (not in this version)"};
}
EffectState no_large_deformation(const Scene&) {
  return {false, "not in this version"};
}

constexpr std::array kFrictionKeys{EffectKey{"contact", {.name = "friction"}, "friction"}};
constexpr std::array kViscosityKeys{EffectKey{"bodies", {.name = "relaxation"}, "viscosity"}};
constexpr std::array kVolumetricKeys{
    EffectKey{"bodies", {.name = "volumetric"}, "the near-incompressible treatment"}};

constexpr std::string_view kUnbalanced =
    "its forces do not balance, so that there is no one normal force to hold friction against";
constexpr std::array kFrictionExcludes{
    Exclusion{Choice::ContactModel, "kuroda", kUnbalanced},
    Exclusion{Choice::ContactModel, "sibille", kUnbalanced},
};

constexpr Effect kFriction{
    .name = "friction", .keys = kFrictionKeys, .excludes = kFrictionExcludes, .state = no_friction};
constexpr Effect kViscosity{.name = "viscosity", .keys = kViscosityKeys, .state = no_viscosity};
constexpr Effect kNearIncompressibility{
    .name = "near-incompressibility", .keys = kVolumetricKeys, .state = no_near_incompressibility};
constexpr Effect kLargeDeformation{.name = "large deformation", .state = no_large_deformation};

constexpr std::array<const Effect*, 4> kLaterEffects{
    &kFriction,
    &kViscosity,
    &kNearIncompressibility,
    &kLargeDeformation,
};

}  // namespace

std::span<const Effect* const> later_effects() {
  return kLaterEffects;
}

}  // namespace palpate::sim
