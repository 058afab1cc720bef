#pragma once

#include "trials/adaptive/adaptive.hpp"

namespace palpate::trials {

/// QUEST [WatsonPelli1983]: one threshold on a fine grid, normal beforehand, a Weibull function of known
/// slope; the next level is the mean, the mode or a quantile of what is known.
extern const AdaptiveProcedure kQuest;

}  // namespace palpate::trials
