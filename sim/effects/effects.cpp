#include "sim/effects/effects.hpp"

#include <vector>

#include "sim/effects/contact/contact.hpp"
#include "sim/effects/friction/friction.hpp"
#include "sim/effects/later/later.hpp"
#include "sim/scene/accepted.hpp"

namespace palpate::sim {

std::span<const Effect* const> effects() {
  static const std::vector<const Effect*> all = [] {
    std::vector<const Effect*> list{
        &kContact,
        &kFriction,
    };
    const auto later = later_effects();
    list.insert(list.end(), later.begin(), later.end());
    return list;
  }();
  return all;
}

void fill_effects(const Scene& scene, Model& model) {
  for (const Effect* effect : effects())
    if (effect->state(scene).on) effect->fill(scene, model);
}

std::span<const EffectKey> effect_keys() {
  static const std::vector<EffectKey> all = [] {
    std::vector<EffectKey> keys;
    for (const Effect* effect : effects()) keys.insert(keys.end(), effect->keys.begin(), effect->keys.end());
    return keys;
  }();
  return all;
}

}  // namespace palpate::sim
