#pragma once

#include "analysis/report/study_table.hpp"
#include "trials/study/study_file.hpp"

namespace palpate::app {

/// What the kind of an event is called that holds the analysis plan, frozen before the first answer, as JSON.
constexpr std::string_view kPlanFrozen = "plan frozen";

/// What a protocol fixed before the first answer, as the analysis reads it.
analysis::StudyDesign design_of(const trials::Protocol& protocol);

/// A study file as the plain tables that the report reads, its answers as answered_trials() joins them. With
/// `curves` false there are no force curves, and no trace is read. Throws std::invalid_argument for a damaged trace.
analysis::StudyTable read_study_table(const trials::StudyFile& study, bool curves = true);

}  // namespace palpate::app
