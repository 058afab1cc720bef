#pragma once

#include "analysis/report/study_table.hpp"
#include "trials/study/study_file.hpp"

namespace palpate::app {

/// What the kind of an event is called that holds the analysis plan, frozen before the first answer, as JSON.
constexpr std::string_view kPlanFrozen = "plan frozen";

/// What a protocol fixed before the first answer, as the analysis reads it.
analysis::StudyDesign design_of(const trials::Protocol& protocol);

/// A study file as the plain tables that the report reads, its answers as answered_trials() joins them. Force
/// curves are means over at most 200 presentations of each stimulus, evenly spread over the study; with
/// `curves` false there are none, and no trace is read. Throws std::invalid_argument for a damaged trace.
analysis::StudyTable read_study_table(const trials::StudyFile& study, bool curves = true);

/// Force at every 0.25 mm of depth: the mean over the moments at which the finger passed that depth inward,
/// interpolated between samples. Entry i belongs to i * 0.25 mm; depths that were not passed are NaN at the
/// front, and there are none beyond the deepest.
std::vector<double> force_at_depths(const trials::Trace& trace);

}  // namespace palpate::app
