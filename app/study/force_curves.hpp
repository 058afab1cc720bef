#pragma once

#include <vector>

#include "analysis/report/study_table.hpp"
#include "trials/study/answered_trials.hpp"
#include "trials/study/study_file.hpp"

namespace palpate::app {

/// Adds the force curve of each stimulus that was pressed for an answer that counts, cell by cell, in the
/// protocol's order of conditions: the mean over at most 200 presentations, evenly spread over the study.
/// Throws std::invalid_argument for a damaged trace.
void add_curves(const trials::StudyFile& study, const std::vector<trials::AnsweredTrial>& answered,
                analysis::StudyTable& table);

/// Force at every 0.25 mm of depth: the mean over the moments at which the finger passed that depth inward,
/// interpolated between samples. Entry i belongs to i * 0.25 mm; depths that were not passed are NaN at the
/// front, and there are none beyond the deepest.
std::vector<double> force_at_depths(const trials::Trace& trace);

}  // namespace palpate::app
