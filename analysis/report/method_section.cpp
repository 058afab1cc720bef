#include "analysis/report/method_section.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "analysis/report/summary.hpp"
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

std::string task(const StudyReport& report) {
  const StudyDesign& design = report.design;
  std::vector<std::string> cells;
  for (const DesignCell& cell : design.cells) cells.push_back(cell.name);
  std::string text = fmt::format(
      "Each trial was a two-interval forced choice between {}; the correct answer was the interval with {}.",
      listed(design.conditions), design.correct_condition);
  if (!design.question.empty()) text += fmt::format(" Question: \"{}\".", design.question);
  if (!design.factors.empty())
    text += fmt::format(" Between trials {} took the values {}.", listed(design.factors), listed(cells));
  if (design.trials_per_examinee_per_cell > 0) {
    const long each = design.trials_per_examinee_per_cell, all = each * static_cast<long>(cells.size());
    text += fmt::format(" Each examinee was to answer {}{}.", counted(each, "trial", "trials"),
                        cells.size() > 1 ? fmt::format(" for each of them, {} in all", all) : "");
  }
  return text;
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
      "Primary test, fixed in the protocol: {} of the number of correct answers for each {} against 1/2 "
      "(paired comparison; alpha {}, {}).{} Intervals for proportions are two-sided Clopper-Pearson "
      "intervals of {}.",
      design.primary == "paired-comparison"
          ? "exact binomial test"
          : "exact randomisation test over the orders that could have been drawn (answers held fixed)",
      design.factors.empty() ? "cell" : "value of " + listed(design.factors), design.alpha,
      design.side == "two-sided" ? "two-sided" : "one-sided: " + design.side, looks(design),
      short_percent(report.options.level));
  text +=
      " Secondary: a sign-flip permutation test of the examinees' proportions correct against 1/2, with an "
      "interval by test inversion; d' = sqrt(2) z(proportion correct), at 0 and 100 % corrected by 1/(2n) "
      "(Macmillan & Kaplan 1985); the share of answers '1' against 1/2 (interval bias).";
  if (design.cells.size() > 1) {
    text += fmt::format(
        " Cells were compared on the differences of proportions correct within examinees, two-sided, by a "
        "sign-flip permutation test{} and Wilcoxon's signed-rank test (exact up to 500 differences, zeros "
        "by Pratt's rule){}.",
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

void add_sample_limits(const StudyReport& report, std::vector<std::string>& limits) {
  if (report.complete_examinees > report.planned_examinees) {
    limits.push_back(fmt::format(
        "{} complete where {} planned. The tests count the first {} to complete. The "
        "count with everybody is no part of the plan: were the results looked at on the way, alpha does not "
        "hold for it.",
        counted(report.complete_examinees, "examinee is", "examinees are"),
        counted(report.planned_examinees, "was", "were"), report.planned_examinees));
  }
  const auto unfinished = std::ranges::count_if(
      report.sessions, [](const ReportedSession& session) { return !session.finished; });
  if (unfinished > 0) {
    limits.push_back(fmt::format("{} not finished; {}.", counted(unfinished, "session is", "sessions are"),
                                 report.sample
                                     ? "no answer is counted of an examinee who is not complete"
                                     : "the answers given so far are counted, but for what weighs each "
                                       "examinee the same, where only complete ones enter"));
  }
  if (report.sessions.size() > report.examinees.size()) {
    limits.push_back(report.sample
                         ? "Some examinees sat more than one session: their answers are counted as one "
                           "examinee's, up to the one that completes what was planned."
                         : "Some examinees sat more than one session: all their answers are counted, as one "
                           "examinee's.");
  }
  const auto resumed = std::ranges::count_if(
      report.sessions, [](const ReportedSession& session) { return session.times_resumed > 0; });
  if (resumed > 0) {
    limits.push_back(
        fmt::format("{} interrupted and resumed: the interrupted trial was presented again in a new order, "
                    "so its examinee felt a stimulus more often than the others.",
                    counted(resumed, "session was", "sessions were")));
  }
  const auto seeded = std::ranges::count_if(report.sessions, [](const ReportedSession& session) {
    return session.order_source.starts_with("seed");
  });
  if (seeded > 0 && report.run_mode != "simulated") {
    limits.push_back(
        fmt::format("The order of {} was drawn from a seed that somebody chose: whoever knows it could know "
                    "the answers.",
                    counted(seeded, "session", "sessions")));
  }
}

std::string spread_in_words(const StudyReport& report, const CellResult& cell) {
  const BetaBinomial& spread = *cell.spread;
  const std::string found =
      fmt::format("overdispersion {} ({} interval {}; Tarone's test {})", decimals(spread.gamma.estimate, 2),
                  short_percent(spread.gamma.interval.level),
                  range(spread.gamma.interval, [](double value) { return decimals(value, 2); }),
                  p_in_words(spread.tarone.p));
  if (!report.complete) return fmt::format("{}: {}; {}.", cell.name, found, kNoClaim);
  return spread.tarone.p <= report.design.alpha
             ? fmt::format(
                   "{}: examinees differ more than chance explains: {}. Read the examinee-level result.",
                   cell.name, found)
             : fmt::format("{}: it is not shown that examinees differ: {}.", cell.name, found);
}

void add_test_limits(const StudyReport& report, std::vector<std::string>& limits) {
  double none = 1.0;  // probability that no test rejects when all is guessing
  long tested = 0;
  for (const CellResult& cell : report.cells) {
    if (!cell.primary) continue;
    none *= 1 - cell.primary->size;
    ++tested;
  }
  if (tested > 1) {
    limits.push_back(fmt::format(
        "Each of the {} primary tests has its own alpha of {}; were all answers guesses, at least "
        "one would reject with probability {}{}.",
        tested, report.design.alpha, number(1 - none),
        report.look && report.look->number > 1 ? ", at this look or at one before" : ""));
  }
  limits.push_back(
      "Answers of one examinee resemble each other when they are more than guesses. The pooled test stays "
      "exact, because it is about guessing; its interval and d' treat all answers as alike and may be too "
      "narrow for people in general.");
  for (const CellResult& cell : report.cells)
    if (cell.spread) limits.push_back(spread_in_words(report, cell));
  for (const CellResult& cell : report.cells) {
    if (!cell.bias || cell.bias->p.two_sided > report.design.alpha) continue;
    limits.push_back(
        fmt::format("{}: {} of the answers named the first interval (against 1/2: {}). An interval is "
                    "favoured, so the proportion correct understates the sensitivity; see d' by order{}.",
                    cell.name, percent(cell.bias->share_first), p_in_words(cell.bias->p.two_sided),
                    report.complete ? "" : fmt::format(" ({})", kNoClaim)));
  }
}

void add_stimulus_limits(const StudyReport& report, std::vector<std::string>& limits) {
  double clamped = 0.0;
  long missed = 0;
  for (const StimulusSummary& stimulus : report.stimuli) {
    clamped = std::max(clamped, stimulus.worst_clamped_fraction.value_or(0.0));
    missed += stimulus.missed_cycles.value_or(0);
  }
  if (clamped > 0) {
    limits.push_back(
        fmt::format("The device's limit cut the force in up to {} of an interval's cycles: the stimulus was "
                    "not everywhere what the model computed.",
                    percent(clamped)));
  }
  if (missed > 0) {
    limits.push_back(fmt::format("The haptic loop missed {} in all intervals together.",
                                 counted(missed, "cycle", "cycles")));
  }
  const bool scaled = std::ranges::any_of(
      report.sessions, [](const ReportedSession& session) { return session.force_scale != 1.0; });
  if (scaled)
    limits.push_back("Forces were scaled before they were displayed; the factor stands with each session.");
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

std::vector<std::string> limits(const StudyReport& report, const std::vector<std::string>& notes) {
  std::vector<std::string> limits = report.banners;
  add_sample_limits(report, limits);
  add_test_limits(report, limits);
  add_stimulus_limits(report, limits);
  if (!report.voided.empty()) {
    limits.push_back(
        fmt::format("{} voided and not counted; the reasons are listed.",
                    counted(static_cast<long>(report.voided.size()), "trial was", "trials were")));
  }
  for (const LookEvent& look : report.interim_looks)
    limits.push_back(
        fmt::format("The results were looked at before the planned sample was complete, on {}: {}.", look.utc,
                    look.text));
  limits.insert(limits.end(), notes.begin(), notes.end());
  return limits;
}

}  // namespace palpate::analysis
