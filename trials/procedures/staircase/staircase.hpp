#pragma once

#include "trials/adaptive/adaptive.hpp"

namespace palpate::trials {

/// Transformed up-down [Levitt1971]: so many correct answers in a row lower the level, so many wrong ones
/// raise it.
extern const AdaptiveProcedure kStaircase;

}  // namespace palpate::trials
