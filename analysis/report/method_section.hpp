#pragma once

#include <string>
#include <vector>

#include "analysis/report/report.hpp"

namespace palpate::analysis {

/// The method section as a paper would print it: examinees, stimuli, procedure, order, analysis, and what the
/// study file does not know.
std::vector<std::string> method_section(const StudyReport& report);

/// What a reader must hold against the results, a sentence or two each.
std::vector<std::string> limits(const StudyReport& report, const std::vector<std::string>& notes);

}  // namespace palpate::analysis
