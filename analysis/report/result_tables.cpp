#include <fmt/core.h>

#include <cmath>
#include <set>

#include "analysis/report/evidence.hpp"
#include "analysis/report/summary.hpp"
#include "analysis/report/tables.hpp"
#include "analysis/report/verdict.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

std::string order_cell(long correct, long trials) {
  if (trials == 0) return "none";
  return fmt::format("{} ({})", out_of(correct, trials),
                     percent(static_cast<double>(correct) / static_cast<double>(trials)));
}

}  // namespace

TextTable verdict_table(const StudyReport& report) {
  const bool adjusts = report.design.adjust != "none";
  TextTable table{
      .title = "Verdict",
      .header = {"cell", "verdict", "correct", "%", short_percent(report.options.level) + " interval", "p"}};
  if (adjusts) table.header.push_back(fmt::format("p, {}", adjustment_in_words(report.design.adjust)));
  std::size_t tested = 0;
  for (const CellResult& cell : report.cells) {
    std::vector<std::string> row{cell.name, std::string(in_words(verdict(report, cell))),
                                 out_of(cell.correct, cell.trials)};
    if (cell.primary) {
      ++tested;
      row.push_back(percent(cell.primary->proportion));
      row.push_back(percent_range(cell.primary->interval));
      row.push_back(bare_p(cell.primary->p.of(cell.primary->side)));
      if (cell.p_adjusted) row.push_back(bare_p(*cell.p_adjusted));
    }
    row.resize(table.header.size(), kNotAvailable);
    table.rows.push_back(row);
  }
  if (tested > 1)
    table.note = adjusts ? fmt::format("The verdict counts p adjusted over the {} cells, at alpha {}.",
                                       tested, report.design.alpha)
                         : fmt::format(
                               "Each of the {} cells is tested by itself at alpha {}; nothing is adjusted "
                               "for their number.",
                               tested, report.design.alpha);
  return table;
}

TextTable evidence_table(const StudyReport& report) {
  TextTable table{.title = "Where no difference is shown",
                  .header = {"cell", "told apart, at most",
                             fmt::format("p of similarity (below {})", short_percent(kSimilarBelow)),
                             "Bayes factor for chance", "in words"}};
  for (const CellResult& cell : report.cells) {
    if (!cell.evidence) continue;
    const EvidenceForChance& evidence = *cell.evidence;
    const bool similarity = evidence.similarity.has_value();
    table.rows.push_back({cell.name,
                          similarity ? percent(evidence.similarity->discriminators_up_to) : kNotAvailable,
                          similarity ? bare_p(evidence.similarity->p) : kNotAvailable,
                          number(std::exp(-evidence.bayes.log_bayes_factor)),
                          evidence_in_words(evidence.bayes.log_bayes_factor)});
  }
  table.note = fmt::format(
      "Told apart: the share of presentations whose answer is no guess, with its one-sided {} bound. Similarity: "
      "exact test of the hypothesis that {} or more are told apart (ISO 4120); secondary, for the protocol names "
      "no bound. Bayes factor: chance against a uniform prior beside it; Kass and Raftery's words.",
      short_percent(report.options.level), short_percent(kSimilarBelow));
  return table;
}

TextTable learning_table(const StudyReport& report) {
  TextTable table{.title = "The first half of each examinee's answers beside the last",
                  .header = {"cell", "first half", "last half", "mean difference (points)",
                             short_percent(report.options.level) + " interval", "p (sign-flip)"}};
  for (const CellResult& cell : report.cells) {
    if (!cell.learning) continue;
    const Learning& learning = *cell.learning;
    const Interval& interval = learning.sign_flip.interval;
    table.rows.push_back({cell.name, order_cell(learning.correct_first, learning.trials_first),
                          order_cell(learning.correct_last, learning.trials_last),
                          fmt::format("{:+.1f}", 100 * learning.mean_difference + 0.0),
                          range({.lower = 100 * interval.lower, .upper = 100 * interval.upper},
                                [](double value) { return fmt::format("{:+.1f}", value); }),
                          bare_p(learning.sign_flip.p.two_sided)});
  }
  table.note =
      "Within each cell and examinee, in the order of the trials; differences of proportions correct, last half "
      "less first, two-sided.";
  return table;
}

TextTable primary_table(const StudyReport& report) {
  const std::string level = short_percent(report.options.level);
  const bool one_sided = report.design.side != "two-sided";
  TextTable table{
      .title = "Correct answers, all examinees together",
      .header = {"cell", "correct", "rejects guessing", "p", level + " interval", "over examinees"}};
  if (one_sided) table.header.push_back(level + " bound");
  for (const CellResult& cell : report.cells) {
    std::vector<std::string> row{cell.name, out_of(cell.correct, cell.trials)};
    if (cell.primary) {
      const std::string region = region_in_words(cell.primary->critical);
      row.push_back(region.empty() ? "no number" : region.substr(0, region.find(" correct")));
      row.push_back(bare_p(cell.primary->p.of(cell.primary->side)));
      row.push_back(percent_range(cell.primary->interval));
      row.push_back(cell.over_examinees ? percent_range(*cell.over_examinees) : "none");
      if (report.design.side == "greater") row.push_back("at least " + percent(cell.primary->bound.lower));
      if (report.design.side == "less") row.push_back("at most " + percent(cell.primary->bound.upper));
    }
    row.resize(table.header.size(), kNotAvailable);
    table.rows.push_back(row);
  }
  table.note = fmt::format("{} against {}, alpha {}, side {}.{}", primary_in_words(report.design),
                           chance_in_words(report.design.chance), report.design.alpha, report.design.side,
                           report.design.adjust == "none" ? "" : " Before the adjustment over the cells.");
  if (report.look && report.look->of > 1) {
    table.note += fmt::format(" Look {} of {}: the region of rejection is that of {} spending.",
                              report.look->number, report.look->of, report.design.spending);
  }
  table.note +=
      " Intervals are two-sided Clopper-Pearson intervals, which take the answers for independent; over examinees: "
      "from a bootstrap that draws whole examinees, so that what one of them answers may hang together.";
  if (one_sided && report.design.primary == "paired-comparison")
    table.note += fmt::format(
        " The one-sided bound is the one that belongs to the test, so a result may be significant though the "
        "two-sided interval just includes {}.",
        short_percent(report.design.chance));
  return table;
}

TextTable people_table(const StudyReport& report) {
  TextTable table{.title = "Correct answers, examinee by examinee",
                  .header = {"cell", "examinees", "mean", "standard deviation",
                             report.design.side == "two-sided" ? "two-sided p" : "one-sided p",
                             short_percent(report.options.level) + " interval of the mean"}};
  std::set<std::string> tests, intervals;
  for (const CellResult& cell : report.cells) {
    std::vector<std::string> row{cell.name};
    if (cell.by_people) {
      const ExamineeLevelTest& test = *cell.by_people;
      row.insert(row.end(),
                 {std::to_string(test.examinees), percent(test.mean_proportion),
                  test.examinees > 1 ? percent(test.deviation) : kNotAvailable,
                  bare_p(test.p.of(side_from_name(report.design.side))), percent_range(test.interval)});
      tests.insert(test.test.method.name);
      if (!std::isnan(test.interval.lower)) intervals.insert(test.interval.method);
    }
    row.resize(table.header.size(), kNotAvailable);
    table.rows.push_back(row);
  }
  if (!tests.empty()) {
    table.note = fmt::format("Each examinee's proportion correct against {}, side {}: {}",
                             chance_in_words(report.design.chance), report.design.side,
                             listed({tests.begin(), tests.end()}));
    table.note += intervals.empty()
                      ? "."
                      : fmt::format("; intervals by {}.", listed({intervals.begin(), intervals.end()}));
  }
  return table;
}

TextTable comparison_table(const StudyReport& report) {
  const auto label = [&](const std::string& name, const std::string& key) {
    return name + (report.design.between_models == key ? ": p (planned)" : ": p (secondary)");
  };
  TextTable table{.title = fmt::format("{}, compared within examinees", factors_in_words(report.design)),
                  .header = {"comparison", "examinees", "mean difference (points)",
                             short_percent(report.options.level) + " interval",
                             label("sign-flip", "sign-flip"), label("Wilcoxon", "wilcoxon")}};
  const std::size_t planned = planned_contrasts(report.design);
  const bool adjusts = planned > 1 && report.design.adjust != "none";
  if (adjusts) table.header.push_back(fmt::format("p, {}", adjustment_in_words(report.design.adjust)));
  for (const CellComparison& comparison : report.comparisons) {
    std::vector<std::string> row{name_of(comparison.contrast), std::to_string(comparison.examinees)};
    row.push_back(comparison.examinees > 0 ? fmt::format("{:+.1f}", 100 * comparison.mean_difference + 0.0)
                                           : kNotAvailable);
    if (comparison.sign_flip) {
      row.push_back(points_range(comparison));
      row.push_back(bare_p(comparison.sign_flip->p.two_sided));
    }
    row.push_back(comparison.signed_rank ? bare_p(comparison.signed_rank->p.two_sided) : kNotAvailable);
    if (adjusts) row.push_back(comparison.p_adjusted ? bare_p(*comparison.p_adjusted) : kNotAvailable);
    row.resize(table.header.size(), kNotAvailable);
    table.rows.push_back(row);
  }
  table.note = "Differences of proportions correct in percentage points; p values are two-sided.";
  if (planned > 1)
    table.note +=
        " Planned are the main effects and the interaction (a difference of differences); pairs of cells are "
        "secondary.";
  return table;
}

TextTable sensitivity_table(const StudyReport& report) {
  const std::string correct =
      report.design.correct_condition.empty() ? "correct condition" : report.design.correct_condition;
  TextTable table{.title = "d', and correct answers by the interval that held the correct condition",
                  .header = {"cell", "d'", short_percent(report.options.level) + " interval", "d' by order",
                             correct + " first", correct + " second", "answers '1'", "p (against 1/2)"}};
  bool corrected = false;
  for (const CellResult& cell : report.cells) {
    std::vector<std::string> row{cell.name};
    if (cell.d_prime && cell.bias) {
      const IntervalBias& bias = *cell.bias;
      const bool by_order = bias.d_prime && bias.d_prime->corrected;
      corrected = corrected || cell.d_prime->corrected || by_order;
      row.insert(row.end(),
                 {decimals(cell.d_prime->d_prime, 2) + (cell.d_prime->corrected ? " *" : ""),
                  range(cell.d_prime->interval, [](double value) { return decimals(value, 2); }),
                  bias.d_prime ? decimals(bias.d_prime->d_prime, 2) + (by_order ? " *" : "") : kNotAvailable,
                  order_cell(bias.counts.correct_first, bias.counts.trials_first),
                  order_cell(bias.counts.correct_second, bias.counts.trials_second),
                  percent(bias.share_first), bare_p(bias.p.two_sided)});
    }
    row.resize(table.header.size(), kNotAvailable);
    table.rows.push_back(row);
  }
  table.note =
      "d' = sqrt(2) z(proportion correct) for an observer without a preferred interval; 'd' by order' does "
      "without that assumption. Correct answers are given by the interval that held the correct condition; "
      "the share of answers '1' is tested against 1/2, two-sided.";
  if (corrected) table.note += " * 0 or 100 % corrected by 1/(2n) (Macmillan & Kaplan 1985).";
  return table;
}

}  // namespace palpate::analysis
