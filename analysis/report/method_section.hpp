#pragma once

#include <string>
#include <vector>

#include "analysis/report/report.hpp"

namespace palpate::analysis {

/// The method section as a paper would print it: examinees, stimuli, procedure, order, analysis, and what the
/// study file does not know.
std::vector<std::string> method_section(const StudyReport& report);

}  // namespace palpate::analysis
