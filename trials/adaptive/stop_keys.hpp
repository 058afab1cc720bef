#pragma once

#include <array>

#include "trials/adaptive/adaptive.hpp"
#include "trials/adaptive/level_reader.hpp"

namespace palpate::trials {

inline constexpr base::Key kStopKey{
    .name = "stop",
    .takes = base::takes_table("a table such as { reversals = 8 } or { trials = 40 }"),
    .example = "{ reversals = 8 }",
    .absent = "the procedure goes on for as long as answers come",
    .meaning = "When the run ends: after so many reversals or answers; with both, at what comes first."};

/// For a procedure that knows no reversals.
inline constexpr base::Key kStopAfterTrialsKey{.name = "stop",
                                               .takes = base::takes_table("a table such as { trials = 40 }"),
                                               .example = "{ trials = 40 }",
                                               .absent = "the procedure goes on for as long as answers come",
                                               .meaning = "When the run ends: after so many answers."};

/// @param by_reversals  whether the procedure has any
StopRule read_stop(LevelReader& procedure, bool by_reversals);

}  // namespace palpate::trials
