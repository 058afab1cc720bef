#pragma once

#include <optional>
#include <vector>

#include "analysis/report/report.hpp"
#include "analysis/report/select.hpp"

namespace palpate::analysis {

/// Learning or tiring over the trials of each cell: an examinee's answers in the order in which they were
/// given, the first half beside the last. Empty for a cell where no examinee has two answers.
/// @param trials  those that count
std::vector<std::optional<Learning>> learning(const Selection& selection,
                                              const std::vector<const TrialRow*>& trials, std::size_t cells,
                                              double level);

}  // namespace palpate::analysis
