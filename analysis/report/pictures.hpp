#pragma once

#include <string>

#include "analysis/report/report.hpp"

namespace palpate::analysis {

// The report's pictures, as SVG inside HTML; empty where there is nothing to draw.

/// Correct answers of each cell, what guessing would give, and the critical number: Fig. 9 of [Kuroda2003].
std::string answers_picture(const StudyReport& report);

/// Examinees up to which the next picture has a row for each.
constexpr std::size_t kMostRows = 150;

/// Proportion correct of each examinee under each cell, a row for each examinee; a histogram of larger
/// studies.
std::string examinees_picture(const StudyReport& report);

/// Mean force over depth by condition, a panel for each cell: Fig. 8 of [Kuroda2003] as the study presented
/// it.
std::string curves_picture(const StudyReport& report);

/// Proportion correct by the interval that held the correct condition, with its interval, for each cell.
std::string orders_picture(const StudyReport& report);

/// Range, quartiles and median of the response times of each cell.
std::string times_picture(const StudyReport& report);

/// How late the haptic loop was at worst, for each stimulus, beside its period.
std::string loop_picture(const StudyReport& report);

}  // namespace palpate::analysis
