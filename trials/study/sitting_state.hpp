#pragma once

#include <span>
#include <vector>

#include "trials/procedure/procedure.hpp"
#include "trials/study/answered_trials.hpp"

namespace palpate::trials {

/// What a procedure hears of an answer.
Told told_of(const DrawnTrial& drawn, const AnswerRow& answer);

/// Of a sitting's trials those that were drawn before its first answer, as first drawn, in order. `events`
/// may be those of the whole file.
std::vector<DrawnTrial> drawn_ahead(std::span<const DrawnTrial> trials, std::span<const EventRow> events);

/// What a procedure was told of a sitting's answers, in order; of a damaged file those whose trial is there.
std::vector<Told> told_by(const SittingRows& sitting);

/// The levels of trials that were drawn ahead.
std::vector<ChosenLevel> levels_of(std::span<const DrawnTrial> ahead);

}  // namespace palpate::trials
