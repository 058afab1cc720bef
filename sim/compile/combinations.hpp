#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/model/effect.hpp"
#include "sim/model/exclusion.hpp"
#include "sim/model/probe_kind.hpp"
#include "sim/scene/scene.hpp"

namespace palpate::sim {

// Which of its choices a scene cannot have together: a table made of what effects and probe kinds state of
// themselves.

/// A row of the table.
struct Combination {
  Choice choice = Choice::Effect;  // of what states it: an effect or a probe kind
  std::string_view name{};
  Exclusion other{};
};
std::vector<Combination> unsupported_combinations(std::span<const Effect* const> effects,
                                                  std::span<const ProbeKind* const> kinds);

/// Throws RefusedKey where a scene has both sides of a row: key and value of each, why, and what is accepted.
void refuse_combinations(const Scene& scene, std::span<const Effect* const> effects,
                         std::span<const ProbeKind* const> kinds);

}  // namespace palpate::sim
