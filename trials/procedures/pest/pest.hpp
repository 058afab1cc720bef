#pragma once

#include "trials/adaptive/adaptive.hpp"

namespace palpate::trials {

/// PEST, parameter estimation by sequential testing [TaylorCreelman1967]: a level is asked until its share
/// correct is seen to be off the target; steps are halved and doubled by rule, and the run ends at the
/// smallest.
extern const AdaptiveProcedure kPest;

}  // namespace palpate::trials
