#include "analysis/report/verdict.hpp"

#include "analysis/statistics/adjust/adjust.hpp"

namespace palpate::analysis {

bool rejects_guessing(const StudyReport& report, const CellResult& cell) {
  if (cell.p_adjusted) return *cell.p_adjusted <= report.design.alpha;
  return rejects(cell.primary->critical, cell.correct);
}

namespace {

/// Whether the answers lie where a one-sided test does not look.
bool is_beyond(const StudyDesign& design, const PrimaryTest& test) {
  return (design.side == "greater" && test.interval.upper < test.chance) ||
         (design.side == "less" && test.interval.lower > test.chance);
}

}  // namespace

Verdict verdict(const StudyReport& report, const CellResult& cell) {
  if (!cell.primary) return Verdict::NoAnswers;
  if (!report.complete && !report.look) return Verdict::NoClaim;
  if (!rejects_guessing(report, cell))
    return report.complete && is_beyond(report.design, *cell.primary) ? Verdict::OtherWay : Verdict::NotShown;
  return cell.primary->proportion > cell.primary->chance ? Verdict::ToldApart : Verdict::WrongWayRound;
}

std::string_view in_words(Verdict verdict) {
  switch (verdict) {
    case Verdict::NoAnswers:
      return "no answers";
    case Verdict::NoClaim:
      return "no claim yet";
    case Verdict::ToldApart:
      return "told apart";
    case Verdict::WrongWayRound:
      return "told apart, the wrong way round";
    case Verdict::NotShown:
      return "not shown";
    case Verdict::OtherWay:
      return "not shown, but off chance the other way";
  }
  return "";
}

void adjust_cells(StudyReport& report) {
  if (report.design.adjust == "none") return;
  std::vector<double> p;
  for (const CellResult& cell : report.cells)
    if (cell.primary) p.push_back(cell.primary->p.of(cell.primary->side));
  if (p.empty()) return;
  const std::vector<double> all = adjusted(report.design.adjust, p);
  std::size_t next = 0;
  for (CellResult& cell : report.cells)
    if (cell.primary) cell.p_adjusted = all[next++];
}

double planned_p(const CellComparison& comparison) {
  const bool wilcoxon = comparison.planned == "wilcoxon" && comparison.signed_rank;
  return wilcoxon ? comparison.signed_rank->p.two_sided : comparison.sign_flip->p.two_sided;
}

void adjust_comparisons(StudyReport& report) {
  if (report.design.adjust == "none" || planned_contrasts(report.design) < 2) return;
  std::vector<CellComparison*> tested;
  std::vector<double> p;
  for (CellComparison& comparison : report.comparisons) {
    if (comparison.planned == "none" || !comparison.sign_flip) continue;
    tested.push_back(&comparison);
    p.push_back(planned_p(comparison));
  }
  if (p.empty()) return;
  const std::vector<double> all = adjusted(report.design.adjust, p);
  for (std::size_t i = 0; i < tested.size(); ++i) tested[i]->p_adjusted = all[i];
}

double strictest_alpha(const StudyDesign& design) {
  return design.adjust == "none" ? design.alpha : design.alpha / static_cast<double>(design.cells.size());
}

std::string_view adjustment_in_words(std::string_view method) {
  if (method == "holm") return "Holm";
  if (method == "hochberg") return "Hochberg";
  return method == "benjamini-hochberg" ? "Benjamini-Hochberg" : "no adjustment";
}

}  // namespace palpate::analysis
