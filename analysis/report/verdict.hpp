#pragma once

#include <string_view>

#include "analysis/report/report.hpp"

namespace palpate::analysis {

/// What the planned test says of one cell.
enum class Verdict {
  NoAnswers,      // none was counted
  NoClaim,        // the sample is not complete, and no look is due
  ToldApart,      // guessing is rejected: more are correct than it gives
  WrongWayRound,  // guessing is rejected: fewer are correct
  NotShown,
  OtherWay  // not rejected, for the test is one-sided; but chance lies outside the interval, on the other side
};

/// Whether a cell's primary test rejects guessing: by the critical number; where the protocol adjusts the
/// cells' p values, by an adjusted p that is no greater than alpha.
bool rejects_guessing(const StudyReport& report, const CellResult& cell);

Verdict verdict(const StudyReport& report, const CellResult& cell);

/// "told apart", for a table.
std::string_view in_words(Verdict verdict);

/// Fills CellResult::p_adjusted of the cells that have a primary test, where the protocol adjusts.
void adjust_cells(StudyReport& report);

/// The same for the planned comparisons, where there are several.
void adjust_comparisons(StudyReport& report);

/// p of the test that the plan names for a comparison, two-sided; of the sign-flip test where it names none.
double planned_p(const CellComparison& comparison);

/// What a cell's p may be at most if no other cell rejects: alpha, divided by the number of cells where the
/// protocol adjusts, which holds for every adjustment that it can name.
double strictest_alpha(const StudyDesign& design);

/// "Holm", "Benjamini-Hochberg".
std::string_view adjustment_in_words(std::string_view method);

}  // namespace palpate::analysis
