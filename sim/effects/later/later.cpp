#include "sim/effects/later/later.hpp"

#include <array>

namespace palpate::sim {
namespace {

EffectState no_viscosity(const Scene&) {
  return {false, "no relaxation of a body (not in this version)"};
}
EffectState no_near_incompressibility(const Scene&) {
  return {false, "no volumetric of a body (not in this version)"};
}
EffectState no_large_deformation(const Scene&) {
  return {false, "not in this version"};
}

constexpr std::array kViscosityKeys{EffectKey{"bodies", {.name = "relaxation"}, "viscosity"}};
constexpr std::array kVolumetricKeys{
    EffectKey{"bodies", {.name = "volumetric"}, "the near-incompressible treatment"}};

constexpr Effect kViscosity{.name = "viscosity", .keys = kViscosityKeys, .state = no_viscosity};
constexpr Effect kNearIncompressibility{
    .name = "near-incompressibility", .keys = kVolumetricKeys, .state = no_near_incompressibility};
constexpr Effect kLargeDeformation{.name = "large deformation", .state = no_large_deformation};

constexpr std::array<const Effect*, 3> kLaterEffects{
    &kViscosity,
    &kNearIncompressibility,
    &kLargeDeformation,
};

}  // namespace

std::span<const Effect* const> later_effects() {
  return kLaterEffects;
}

}  // namespace palpate::sim
