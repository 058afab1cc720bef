#pragma once

#include <string>
#include <vector>

#include "analysis/report/report.hpp"

namespace palpate::analysis {

/// What a reader must hold against the results, a sentence or two each; `notes` are the study file's own.
std::vector<std::string> limits(const StudyReport& report, const std::vector<std::string>& notes);

}  // namespace palpate::analysis
