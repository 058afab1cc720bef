#pragma once

#include "trials/adaptive/adaptive.hpp"

namespace palpate::trials {

/// The psi method [KontsevichTyler1999]: threshold and slope on grids, and always the level after whose
/// answer they are expected to be least uncertain.
extern const AdaptiveProcedure kPsi;

}  // namespace palpate::trials
