#include "sim/effects/effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "sim/effects/contact/contact.hpp"
#include "sim/effects/later/later.hpp"
#include "sim/scene/accepted.hpp"

namespace palpate::sim {

std::span<const Effect* const> effects() {
  static const std::vector<const Effect*> all = [] {
    std::vector<const Effect*> list{
        &kContact,
    };
    const auto later = later_effects();
    list.insert(list.end(), later.begin(), later.end());
    return list;
  }();
  return all;
}

void refuse_combinations(const Scene& scene) {
  for (const Effect* effect : effects()) {
    if (effect->excludes.empty() || !effect->state(scene).on) continue;
    for (const Effect* other : effects())
      if (std::ranges::count(effect->excludes, other->name) > 0 && other->state(scene).on)
        throw std::invalid_argument(fmt::format("{} ({}) cannot be combined with {} ({})", effect->name,
                                                effect->state(scene).reason, other->name,
                                                other->state(scene).reason));
  }
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
