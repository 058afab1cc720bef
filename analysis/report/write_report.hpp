#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "analysis/report/report.hpp"

namespace palpate::analysis {

/// One self-contained HTML page: no script, nothing fetched, readable on paper. Everything that comes from a
/// file is escaped.
std::string html_report(const StudyReport& report);

/// For a terminal, at most 100 columns where the words allow; control characters of names are replaced.
std::string text_report(const StudyReport& report);

/// A screenful of it: banners, verdicts, who took part, and the planned comparisons.
/// @param width  columns of the terminal; tables keep theirs
std::string brief_report(const StudyReport& report, std::size_t width = 100);

/// Every number of the report. Proportions are fractions, units stand in the names, what is not there is
/// null.
nlohmann::ordered_json json_report(const StudyReport& report);

}  // namespace palpate::analysis
