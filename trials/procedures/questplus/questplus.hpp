#pragma once

#include "trials/adaptive/adaptive.hpp"

namespace palpate::trials {

/// QUEST+ [Watson2017]: threshold, slope, guess and lapse rate on grids, and always the level after whose
/// answer they are expected to be least uncertain.
extern const AdaptiveProcedure kQuestPlus;

}  // namespace palpate::trials
