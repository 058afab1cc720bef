#pragma once

#include <string>
#include <vector>

#include "analysis/report/report.hpp"

namespace palpate::analysis {

/// "the study file", or in a joined file the part that a plan or session is of.
std::string part_in_words(const StudyReport& report, std::size_t part);

/// What was fixed before the first answer, a sentence or two each: the frozen plans, or that there is none.
std::vector<std::string> plan_in_words(const StudyReport& report);

/// Where the study as it was run departs from its plan, a sentence each; empty: nowhere that its file can
/// tell.
std::vector<std::string> deviations(const StudyReport& report);

}  // namespace palpate::analysis
