#pragma once

#include "trials/procedure/procedure.hpp"

namespace palpate::trials {

/// Cell by cell, in the order of the protocol: each is asked until an answer is wrong, at most
/// trials_per_examinee_per_cell times. The next level depends on the answers, so nothing is drawn ahead.
extern const Procedure kUntilWrong;

}  // namespace palpate::trials
