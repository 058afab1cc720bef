#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analysis/report/evidence.hpp"
#include "analysis/report/summary.hpp"
#include "analysis/report/verdict.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

std::string side_in_words(const StudyReport& report) {
  const StudyDesign& design = report.design;
  const std::string side = design.side == "two-sided" ? "two-sided" : "one-sided: " + design.side;
  if (!report.look) return fmt::format("alpha {}, {}", design.alpha, side);
  return fmt::format("look {} of {}, {} of alpha {} spent, {}", report.look->number, report.look->of,
                     number(report.look->spent), design.alpha, side);
}

std::string told_apart(const StudyReport& report) {
  return fmt::format("told {} apart",
                     report.design.conditions.empty() ? "the conditions" : listed(report.design.conditions));
}

// What a rejection says, in the direction in which it came.
std::string rejection(const StudyReport& report, const CellResult& cell, const std::string& p) {
  const bool better = verdict(report, cell) == Verdict::ToldApart;
  const std::string who = report.run_mode == "simulated" ? "at least one simulated examinee" : "somebody";
  const std::string need = cell.p_adjusted
                               ? fmt::format("Guessing is rejected ({}, {})", p, side_in_words(report))
                               : fmt::format("Guessing is rejected ({}), which takes {} ({})", p,
                                             region_in_words(cell.primary->critical), side_in_words(report));
  if (better) return need + fmt::format(": {} {}.", who, told_apart(report));
  return need + fmt::format(
                    ": fewer answers are correct than guessing gives. So {} {} but named them the wrong way "
                    "round, or the answers are coded the wrong way round.",
                    who, told_apart(report));
}

// A one-sided test says nothing about the side where it does not look; the reader must hear of it all the
// same.
std::string beyond_the_plan(const StudyReport& report, const CellResult& cell) {
  const bool greater = report.design.side == "greater";
  return fmt::format(
      " But the answers lie on the other side of chance, where the planned test does not look: so {} "
      "correct answers are hardly guesses either (two-sided {}, not planned; {} interval {}). The question "
      "may have been understood, or its answers coded, the wrong way round.",
      greater ? "few" : "many", p_in_words(cell.primary->p.two_sided),
      short_percent(cell.primary->interval.level), percent_range(cell.primary->interval));
}

// Not rejected is not the same as not felt: say what remains possible.
std::string no_rejection(const StudyReport& report, const CellResult& cell, const std::string& p) {
  const std::string region = region_in_words(cell.primary->critical);
  const std::string text =
      region.empty()    ? fmt::format("With {} no number of correct ones can reject guessing ({}).",
                                      counted(cell.trials, "answer", "answers"), side_in_words(report))
      : cell.p_adjusted ? fmt::format("Guessing is not rejected ({}, {}).", p, side_in_words(report))
                        : fmt::format("Guessing is not rejected ({}), which would take {} ({}).", p, region,
                                      side_in_words(report));
  const Interval& interval = cell.primary->interval;
  if (verdict(report, cell) == Verdict::OtherWay) return text + beyond_the_plan(report, cell);
  return text + fmt::format(
                    " This does not show that the difference cannot be {}: {} correct is compatible with the "
                    "answers ({} interval).{}",
                    report.pseudo_haptic ? "noticed" : "felt", percent_range(interval),
                    short_percent(interval.level), cell.evidence ? " " + in_words(*cell.evidence) : "");
}

// A look that nobody planned has no alpha to spend.
std::string without_claim(const StudyReport& report, const CellResult& cell, const std::string& p) {
  const Interval& interval = cell.primary->interval;
  return fmt::format("{}: {} ({}), {} interval {}; {}.", primary_in_words(report.design), p,
                     report.design.side == "two-sided" ? "two-sided" : "one-sided: " + report.design.side,
                     short_percent(interval.level), percent_range(interval), kNoClaim);
}

// "p = 0.010", and where the protocol adjusts "p = 0.010, after Holm over 2 cells p = 0.020".
std::string test_in_words(const StudyReport& report, const CellResult& cell) {
  std::string p = p_in_words(cell.primary->p.of(cell.primary->side));
  if (!cell.p_adjusted) return p;
  const auto tested =
      std::ranges::count_if(report.cells, [](const CellResult& other) { return other.primary.has_value(); });
  return fmt::format("{}, after {} over {} {}", p, adjustment_in_words(report.design.adjust),
                     counted(tested, "cell", "cells"), p_in_words(*cell.p_adjusted));
}

std::string primary_sentence(const StudyReport& report, const CellResult& cell) {
  const std::string p = test_in_words(report, cell);
  switch (verdict(report, cell)) {
    case Verdict::ToldApart:
    case Verdict::WrongWayRound:
      return rejection(report, cell, p);
    case Verdict::NotShown:
    case Verdict::OtherWay:
      return no_rejection(report, cell, p);
    case Verdict::NoClaim:
    case Verdict::NoAnswers:
      break;
  }
  return without_claim(report, cell, p);
}

std::string people_sentence(const StudyReport& report, const CellResult& cell) {
  if (!cell.by_people) return " No examinee is complete, so nothing is said examinee by examinee.";
  const ExamineeLevelTest& test = *cell.by_people;
  const Side side = side_from_name(report.design.side);
  const auto n = static_cast<long>(test.examinees);
  if (n == 1) return " With one examinee nothing can be said about people in general.";
  const double p = test.p.of(side);
  const std::string spread =
      std::isnan(test.interval.lower)
          ? "all alike, so that no interval can be given"
          : fmt::format("{} interval {}", short_percent(test.interval.level), percent_range(test.interval));
  std::string text = fmt::format(" Taken examinee by examinee ({}), the mean is {} correct ({}; {} {}): ", n,
                                 percent(test.mean_proportion), spread,
                                 side == Side::TwoSided ? "two-sided" : "one-sided", p_in_words(p));
  if (!report.complete) return text + fmt::format("{}.", kNoClaim);
  const std::string people =
      report.run_mode == "simulated" ? "simulated examinees like these" : "people like these";
  if (least_p(test.examinees, side) > report.design.alpha) {
    return text + fmt::format("with {} this test cannot reach alpha {}, whatever they answer.",
                              examinees_word(report, n), report.design.alpha);
  }
  if (p <= report.design.alpha) {
    return text + fmt::format("{} answer {} than by chance on the average.", people,
                              test.mean_proportion > test.chance ? "better" : "worse");
  }
  const std::string than = side == Side::Greater ? "better" : side == Side::Less ? "worse" : "otherwise";
  return text + fmt::format("it is not shown that {} answer {} than by chance on the average.", people, than);
}

// What all answers give that are in the file, next to those that the plan counts.
std::string all_answers_sentence(const CellResult& cell) {
  if (!cell.all) return "";
  return fmt::format(" With everybody's answers, which is not planned, {} of {} are correct ({}).",
                     cell.all->correct, cell.all->trials,
                     percent(static_cast<double>(cell.all->correct) / static_cast<double>(cell.all->trials)));
}

}  // namespace

std::string cell_summary(const StudyReport& report, const CellResult& cell) {
  if (cell.trials == 0) return cell.name + ": no answers were counted." + all_answers_sentence(cell);
  if (report.withheld) return fmt::format("{}: {}.", cell.name, counted(cell.trials, "answer", "answers"));
  std::string text = fmt::format(
      "{}: {} of {} {} correct ({}).", cell.name, cell.correct, counted(cell.trials, "answer", "answers"),
      cell.correct == 1 || cell.trials == 1 ? "was" : "were",
      percent(static_cast<double>(cell.correct) / static_cast<double>(cell.trials)));
  if (!cell.primary) return text;
  text += " " + primary_sentence(report, cell);
  return text + people_sentence(report, cell) + all_answers_sentence(cell);
}

}  // namespace palpate::analysis
