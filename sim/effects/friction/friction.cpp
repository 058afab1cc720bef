#include "sim/effects/friction/friction.hpp"

#include <fmt/format.h>

#include <array>

#include "base/text/toml_reader.hpp"
#include "sim/contact/exact/exact.hpp"
#include "sim/contact/frictional/frictional.hpp"
#include "sim/effects/contact/contact.hpp"

namespace palpate::sim {
namespace {

constexpr std::string_view kKey = "friction";

std::vector<double> read_coefficient(base::TomlReader& table, std::string_view key) {
  return {table.number(key)};
}

constexpr std::array kKeys{EffectKey{
    .table = "contact",
    .key =
        {.name = kKey,
         .takes = base::takes_number(base::kNotNegative),
         .example = "0.3",
         .absent = "bodies slide on each other freely",
         .meaning =
             "With the contact model `exact`: the coefficient of Coulomb friction between bodies. What touches "
             "sticks until the friction is used up, then slips.",
         .along = "model = \"exact\""},
    .calls_for = "friction",
    .read = read_coefficient}};

constexpr std::string_view kUnbalanced =
    "its forces do not balance, so that there is no one normal force to hold friction against";
constexpr std::array kExcludes{
    Exclusion{Choice::ContactModel, "kuroda", kUnbalanced},
    Exclusion{Choice::ContactModel, "sibille", kUnbalanced},
};

EffectState state_of_friction(const Scene& scene) {
  const auto found = scene.contact.effects.find(std::string(kKey));
  if (found == scene.contact.effects.end()) return {false, "no contact.friction"};
  if (const EffectState contact = kContact.state(scene); !contact.on) return {false, contact.reason};
  return {true, fmt::format("contact.friction = {:g}", found->second.front()), "contact.friction"};
}

void add_friction(const Scene& scene, Model& model) {
  model.friction = scene.contact.effects.at(std::string(kKey)).front();
  model.law = &kFrictional;
}

Model without_friction(Model model) {
  model.law = &kExact;
  return model;
}

}  // namespace

constinit const Effect kFriction{.name = "friction",
                                 .keys = kKeys,
                                 .excludes = kExcludes,
                                 .state = state_of_friction,
                                 .fill = add_friction,
                                 .without = without_friction};

}  // namespace palpate::sim
