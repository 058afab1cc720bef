#include "sim/effects/later/later.hpp"

#include <array>

namespace palpate::sim {
namespace {

Model unchanged(Model model) {
  return model;
}

constexpr std::array<LaterKey, 1> kFrictionKeys{{{"contact", "friction", "friction"}}};
constexpr Effect kFriction{.name = "friction",
                           .later = kFrictionKeys,
                           .state =
                               [](const Scene&) {
                                 return EffectState{false, "no contact.friction (not in this version)"};
                               },
                           .without = unchanged};

constexpr std::array<LaterKey, 1> kViscosityKeys{{{"bodies", "relaxation", "viscosity"}}};
constexpr Effect kViscosity{.name = "viscosity",
                            .later = kViscosityKeys,
                            .state =
                                [](const Scene&) {
                                  return EffectState{false, "no relaxation of a body (not in this version)"};
                                },
                            .without = unchanged};

constexpr std::array<LaterKey, 1> kIncompressibilityKeys{
    {{"bodies", "volumetric", "the near-incompressible treatment"}}};
constexpr Effect kNearIncompressibility{
    .name = "near-incompressibility",
    .later = kIncompressibilityKeys,
    .state =
        [](const Scene&) {
          return EffectState{false, "no volumetric of a body (not in this version)"};
        },
    .without = unchanged};

constexpr Effect kLargeDeformation{
    .name = "large deformation",
    .state =
        [](const Scene&) {
          return EffectState{false, "no key calls for it (not in this version)"};
        },
    .without = unchanged};

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
