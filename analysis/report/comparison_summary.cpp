#include <fmt/core.h>

#include <cmath>

#include "analysis/report/summary.hpp"
#include "analysis/report/verdict.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

// On the average: which of the two is higher, or the effect larger under.
std::string direction(const CellComparison& comparison) {
  const Contrast& contrast = comparison.contrast;
  const double points = 100 * comparison.mean_difference;
  const std::string& more = points > 0 ? contrast.first : contrast.second;
  const std::string& less = points > 0 ? contrast.second : contrast.first;
  if (contrast.kind == Contrast::Kind::Interaction)
    return points == 0 ? fmt::format(
                             "on the average the difference of an examinee's proportions correct is the "
                             "same with {} and with {}",
                             contrast.first, contrast.second)
                       : fmt::format(
                             "on the average the difference of an examinee's proportions correct, {}, is "
                             "{:.1f} percentage points larger with {} than with {}",
                             contrast.effect, std::abs(points), more, less);
  if (points == 0) return "on the average examinees have the same proportion correct under both";
  return fmt::format(
      "on the average an examinee's proportion correct is {:.1f} percentage points higher with {}",
      std::abs(points), more);
}

std::string test_in_words(const StudyReport& report, const CellComparison& comparison) {
  const bool wilcoxon = comparison.planned == "wilcoxon" && comparison.signed_rank;
  std::string text =
      fmt::format("{}, two-sided {}", wilcoxon ? "Wilcoxon signed-rank" : "sign-flip permutation",
                  p_in_words(planned_p(comparison)));
  if (comparison.p_adjusted)
    text += fmt::format(", after {} over the planned comparisons {}",
                        adjustment_in_words(report.design.adjust), p_in_words(*comparison.p_adjusted));
  return text;
}

}  // namespace

std::string comparison_summary(const StudyReport& report, const CellComparison& comparison) {
  std::string text = name_of(comparison.contrast) + ": ";
  if (comparison.examinees == 0)
    return text + fmt::format("no complete examinee has answers counted under {}.",
                              comparison.contrast.kind == Contrast::Kind::Cells ? "both" : "all cells");
  text += direction(comparison);
  if (!comparison.sign_flip) return text + ".";
  const Interval& interval = comparison.sign_flip->interval;
  text += std::isnan(interval.lower)
              ? std::string(" (the same for every examinee, so that no interval can be given).")
              : fmt::format(" ({} interval {}).", short_percent(interval.level),
                            points_range(comparison, comparison.mean_difference < 0));
  const std::string named = test_in_words(report, comparison);
  if (!report.complete) return text + fmt::format(" By {}: {}.", named, kNoClaim);
  if (least_p(comparison.examinees, Side::TwoSided) > report.design.alpha) {
    return text + fmt::format(" With {} no difference can reach alpha {} ({}).",
                              examinees_word(report, static_cast<long>(comparison.examinees)),
                              report.design.alpha, named);
  }
  if (comparison.p_adjusted.value_or(planned_p(comparison)) <= report.design.alpha)
    return text + fmt::format(" The difference is larger than chance explains ({}).", named);
  return text +
         fmt::format(" A difference is not shown ({}), which does not show that there is none.", named);
}

}  // namespace palpate::analysis
