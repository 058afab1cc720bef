#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/report/report.hpp"

namespace palpate::analysis {

// What the report says in words. Every sentence follows from the numbers already in the report.

std::vector<std::string> banners(const StudyReport& report);
std::vector<std::string> summary(const StudyReport& report);

/// One paragraph on a cell: its primary test, then its examinees. True at 0 and 100 %, below chance, for one
/// examinee and for none.
std::string cell_summary(const StudyReport& report, const CellResult& cell);
std::string comparison_summary(const StudyReport& report, const CellComparison& comparison);

/// How many sittings there were and when they began.
std::string sessions_in_words(const StudyReport& report);

/// "37 or more of 60", "21 or fewer, or 39 or more of 60"; empty where no number is enough.
std::string region_in_words(const CriticalNumber& critical);

/// "Exact binomial test", "Exact randomisation test over the balanced orders".
std::string primary_in_words(const StudyDesign& design);

/// The least p that a test on so many signs can give: all alike.
double least_p(std::size_t examinees, Side side);

/// The interval of a comparison in percentage points, cut to what it can be.
/// @param turned  of the second less the first
std::string points_range(const CellComparison& comparison, bool turned = false);

/// What stands with p and interval of whatever is not tested at the alpha of a planned look while the sample
/// is not complete.
constexpr std::string_view kNoClaim = "no claim before the planned sample";

/// "examinees" or "simulated examinees".
std::string examinees_word(const StudyReport& report, long count);

}  // namespace palpate::analysis
