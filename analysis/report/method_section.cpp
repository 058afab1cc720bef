#include "analysis/report/method_section.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "analysis/report/evidence.hpp"
#include "analysis/report/summary.hpp"
#include "analysis/report/verdict.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

// The distinct values of a column of the sessions, in alphabetical order.
template <typename Column>
std::vector<std::string> distinct(const StudyReport& report, Column column) {
  std::set<std::string> values;
  for (const ReportedSession& session : report.sessions) {
    const std::string value = column(session);
    if (!value.empty()) values.insert(value);
  }
  return {values.begin(), values.end()};
}

std::string examinees(const StudyReport& report) {
  const std::vector<std::string> devices =
      distinct(report, [](const ReportedSession& s) { return s.device; });
  std::string text = fmt::format("{} took part in {} ({} planned; {} complete).",
                                 examinees_word(report, static_cast<long>(report.examinees.size())),
                                 counted(static_cast<long>(report.sessions.size()), "session", "sessions"),
                                 report.planned_examinees, report.complete_examinees);
  if (!devices.empty()) text += fmt::format(" Device: {}.", listed(devices));
  if (report.pseudo_haptic) {
    text += fmt::format(" No force reached the hand; the stimulus was carried by {}.",
                        report.channel.empty() ? "a channel that was not recorded" : report.channel);
  }
  return text;
}

std::string feedback(const StudyReport& report) {
  const double time = report.design.feedback_s;
  if (time <= 0) return "";
  if (report.run_mode == "simulated")
    return fmt::format(
        " People are given feedback after each answer, for {} s; simulated examinees are not told, and do not "
        "learn.",
        number(time));
  return fmt::format(
      " Feedback was given: after each answer, once it was saved, the examinee was told for {} s whether it was "
      "right, and which answer was.",
      number(time));
}

std::string task(const StudyReport& report) {
  const StudyDesign& design = report.design;
  std::vector<std::string> cells;
  for (const DesignCell& cell : design.cells) cells.push_back(cell.name);
  std::string text = fmt::format(
      "Each trial was a two-interval forced choice between {}; the correct answer was the interval with {}.",
      listed(design.conditions), design.correct_condition);
  if (!design.question.empty()) text += fmt::format(" Question: \"{}\".", design.question);
  if (!design.factors.empty())
    text += fmt::format(" Between trials {} took the values {}.", listed(design.factors),
                        fmt::format("{}", fmt::join(cells, "; ")));
  if (design.trials_per_examinee_per_cell > 0) {
    const long each = design.trials_per_examinee_per_cell, all = each * static_cast<long>(cells.size());
    text += fmt::format(" Each examinee was to answer {}{}.", counted(each, "trial", "trials"),
                        cells.size() > 1 ? fmt::format(" for each of them, {} in all", all) : "");
  }
  return text + feedback(report);
}

std::string exploration(const StudyReport& report) {
  const StudyDesign& design = report.design;
  std::string text;
  if (design.most_presses > 0) {
    text +=
        design.least_presses == design.most_presses
            ? fmt::format("An interval allowed {}", counted(design.most_presses, "press", "presses"))
            : fmt::format("An interval allowed {} to {} presses", design.least_presses, design.most_presses);
    if (design.max_time_s > 0) text += fmt::format(" within {} s", number(design.max_time_s));
    if (design.min_depth_m > 0)
      text += report.pseudo_haptic
                  ? fmt::format(", the hand going at least once {} mm in", number(1000 * design.min_depth_m))
                  : fmt::format(", at least one of them {} mm deep and in contact",
                                number(1000 * design.min_depth_m));
    text += "; an interval that did not meet this was shown again. ";
  }
  if (!design.display_during_interval.empty()) {
    const std::string shown = design.display_during_interval == "hidden"
                                  ? "nothing of the organs or the probe"
                                  : design.display_during_interval;
    text += fmt::format(
        "On the screen during an interval: {}.",
        report.pseudo_haptic && design.display_during_interval == "hidden"
            ? "the pointer, which is the probe, and the line of the skin, which was elsewhere in every "
              "interval; nothing of the organs"
            : shown);
  }
  return text;
}

std::string order(const StudyReport& report) {
  const std::vector<std::string> sources =
      distinct(report, [](const ReportedSession& s) { return s.order_source; });
  return fmt::format(
      "Trials of all cells were mixed in one order ({}); {}.{}", report.design.cell_order,
      report.design.interval_order == "coin"
          ? "which condition came first was decided by an independent fair coin for each trial"
          : "of each examinee's trials in a cell, half had either condition first, in random sequence",
      sources.empty() ? ""
      : sources.size() <= 5
          ? fmt::format(" Source of randomness: {}.", listed(sources))
          : fmt::format(" Sources of randomness: {} different ones, listed with the sessions.",
                        sources.size()));
}

std::string adjustment(const StudyDesign& design) {
  if (design.adjust == "none") return "";
  return fmt::format(" The cells' p values were adjusted after {}.", adjustment_in_words(design.adjust));
}

std::string looks(const StudyDesign& design) {
  if (design.looks.empty()) return "";
  std::vector<std::string> at;
  for (const int look : design.looks) at.push_back(std::to_string(look));
  return fmt::format(
      " Looks were planned at {} complete examinees, alpha spent over them after Lan and DeMets "
      "({}), with exact binomial probabilities.",
      listed(at), design.spending);
}

std::string analysis_plan(const StudyReport& report) {
  const StudyDesign& design = report.design;
  std::string text = fmt::format(
      "Primary test, fixed in the protocol: {} of the number of correct answers for each {} against {} "
      "(paired comparison; alpha {}, {}).{}{} Intervals for proportions are two-sided Clopper-Pearson "
      "intervals of {}; beside them stand percentile intervals from a bootstrap that draws whole examinees. "
      "Where guessing is not rejected: an exact similarity test at {} told apart, and a Bayes factor with a "
      "uniform prior.",
      design.primary == "paired-comparison"
          ? "exact binomial test"
          : "exact randomisation test over the orders that could have been drawn (answers held fixed)",
      varied_factors(design).empty() ? "cell" : "level of " + factors_in_words(design),
      chance_in_words(design.chance), design.alpha,
      design.side == "two-sided" ? "two-sided" : "one-sided: " + design.side, adjustment(design),
      looks(design), short_percent(report.options.level), short_percent(kSimilarBelow));
  text +=
      " Secondary: a sign-flip permutation test of the examinees' proportions correct against chance, with "
      "an interval by test inversion; each examinee's first half of answers in a cell beside the last half, by a "
      "sign-flip test (learning); d' = sqrt(2) z(proportion correct), at 0 and 100 % corrected by 1/(2n) "
      "(Macmillan & Kaplan 1985); the share of answers '1' against 1/2 (interval bias).";
  if (design.cells.size() > 1) {
    text += fmt::format(
        " Cells were compared on the differences of proportions correct within examinees{}, two-sided, by a "
        "sign-flip permutation test{} and Wilcoxon's signed-rank test (exact up to 500 differences, zeros "
        "by Pratt's rule){}.",
        planned_contrasts(design) > 1
            ? fmt::format(": the main effects of {} and their interaction as planned, pairs of cells besides",
                          factors_in_words(design))
            : "",
        design.between_models == "sign-flip" ? " (planned)" : " (secondary)",
        design.between_models == "wilcoxon" ? " (planned)" : " (secondary)");
  }
  if (!report.sample)
    return text + " No answer was excluded but voided trials; no exclusion rule was applied.";
  return text + fmt::format(
                    " The tests count the first {} to complete all planned trials; of their answers none was "
                    "excluded but voided trials, and no exclusion rule was applied.",
                    examinees_word(report, *report.sample));
}

}  // namespace

std::vector<std::string> method_section(const StudyReport& report) {
  std::vector<std::string> paragraphs{examinees(report), task(report)};
  const std::string explored = exploration(report);
  if (!explored.empty()) paragraphs.push_back(explored);
  paragraphs.push_back(order(report));
  paragraphs.push_back(analysis_plan(report));
  if (report.run_mode != "simulated") {
    paragraphs.push_back(
        "Not in the study file, for the authors to add: how examinees were recruited, their age, "
        "handedness and experience, consent, instructions, practice and breaks, and masking of sound "
        "and sight.");
  }
  return paragraphs;
}

}  // namespace palpate::analysis
