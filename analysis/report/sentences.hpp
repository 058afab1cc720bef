#pragma once

#include <string>
#include <vector>

#include "analysis/report/report.hpp"

namespace palpate::analysis {

/// Fills what the report says in words: banners, summary, claims, method, limits. Every sentence follows from
/// the numbers already in the report; `notes` are the study file's own and end up among the limits.
void write_sentences(const std::vector<std::string>& notes, StudyReport& report);

}  // namespace palpate::analysis
