#pragma once

#include <vector>

#include "analysis/report/report.hpp"
#include "analysis/report/select.hpp"

namespace palpate::analysis {

/// How each condition of each cell was explored and presented, in the protocol's order, over all answers of a
/// selection.
std::vector<StimulusSummary> summarise_stimuli(const StudyDesign& design, const Selection& selection);

}  // namespace palpate::analysis
