#pragma once

#include "trials/procedure/procedure.hpp"

namespace palpate::trials {

/// Constant stimuli: every cell trials_per_examinee_per_cell times, in one random order that is drawn before
/// the first answer.
extern const Procedure kConstant;

}  // namespace palpate::trials
