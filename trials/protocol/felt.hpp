#pragma once

#include <compare>
#include <vector>

#include "sim/scene/scene.hpp"
#include "trials/protocol/protocol.hpp"

namespace palpate::trials {

/// Which of two scenes feels stiffer, as far as their files tell: greater where the first has no softer
/// material, no body less, and is not the same. Unordered where they differ in anything else, or one is
/// stiffer here and softer there.
std::partial_ordering compare_stiffness(const sim::Scene& a, const sim::Scene& b);

/// How the interval with the correct condition feels beside the others, in every cell; nothing where the scenes
/// do not tell. @param scenes  one for each stimulus
std::optional<Answer> answer_told_by(const Protocol& protocol, const std::vector<sim::Scene>& scenes);

}  // namespace palpate::trials
