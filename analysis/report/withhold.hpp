#pragma once

#include "analysis/report/report.hpp"

namespace palpate::analysis {

/// Takes out of a report all that tells how the study stands: before its sample is complete, whoever reads it may
/// know who has sat and how many answers there are, and nothing of what they are.
void withhold_results(StudyReport& report);

}  // namespace palpate::analysis
