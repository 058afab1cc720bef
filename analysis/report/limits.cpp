#include "analysis/report/limits.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "analysis/report/summary.hpp"
#include "analysis/report/verdict.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

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
  if (tested > 1 && report.design.adjust != "none") {
    limits.push_back(fmt::format(
        "The p values of the {} primary tests are adjusted together ({}): were all answers guesses, one or more "
        "would reject with a probability of at most {}.",
        tested, adjustment_in_words(report.design.adjust), report.design.alpha));
  } else if (tested > 1) {
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
  long missed = 0, at_cap = 0;
  for (const StimulusSummary& stimulus : report.stimuli) {
    clamped = std::max(clamped, stimulus.worst_clamped_fraction.value_or(0.0));
    missed += stimulus.missed_cycles.value_or(0);
    at_cap += stimulus.cycles_at_cap.value_or(0);
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
  if (at_cap > 0) {
    limits.push_back(
        fmt::format("The contact's solution ended at its cap on iterations in {} of all intervals together; "
                    "the bound of the force's error stands with the stimuli.",
                    counted(at_cap, "cycle", "cycles")));
  }
  const bool scaled = std::ranges::any_of(
      report.sessions, [](const ReportedSession& session) { return session.force_scale != 1.0; });
  if (scaled)
    limits.push_back("Forces were scaled before they were displayed; the factor stands with each session.");
}

}  // namespace

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
        fmt::format("The results were looked at before the planned sample was complete, on {}: {}.",
                    to_the_second(look.utc) + " UTC", look.text));
  limits.insert(limits.end(), notes.begin(), notes.end());
  return limits;
}

}  // namespace palpate::analysis
