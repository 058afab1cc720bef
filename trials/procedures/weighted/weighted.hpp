#pragma once

#include "trials/adaptive/adaptive.hpp"

namespace palpate::trials {

/// Weighted up-down [Kaernbach1991]: every correct answer lowers the level by one step size, every wrong one
/// raises it by another. It settles where the share correct is step_up / (step_up + step_down).
extern const AdaptiveProcedure kWeighted;

}  // namespace palpate::trials
