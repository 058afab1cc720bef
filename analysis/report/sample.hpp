#pragma once

#include <cstddef>
#include <vector>

#include "analysis/report/select.hpp"

namespace palpate::analysis {

/// An examinee who was asked all that the protocol plans; a voided trial was asked.
struct Completion {
  std::size_t examinee = 0;        // index into Selection::examinees
  const TrialRow* last = nullptr;  // the answer that made it complete
};

/// Who is complete, in the order in which they came to it: that of the answers which made it so. Within a
/// study file its chain tells that order, whatever the clock said; between the files that one was joined from
/// the clocks do, and where these say the same or nothing the place in the table.
std::vector<Completion> completions(const StudyDesign& design, const Selection& selection);

/// The answers of the first `count` complete examinees, each up to the one that made it complete: the same
/// ones however many come after, so that whoever goes on past the plan does not change its test.
std::vector<const TrialRow*> answers_of_first(std::size_t count, const std::vector<Completion>& complete,
                                              const StudyDesign& design, const Selection& selection);

}  // namespace palpate::analysis
