#include "analysis/report/summary.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

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
  const bool better = cell.primary->proportion > cell.primary->chance;
  const std::string who = report.run_mode == "simulated" ? "at least one simulated examinee" : "somebody";
  const std::string need = fmt::format("Guessing is rejected ({}), which takes {} ({})", p,
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
  const std::string text = region.empty()
                               ? fmt::format("With {} no number of correct ones can reject guessing ({}).",
                                             counted(cell.trials, "answer", "answers"), side_in_words(report))
                               : fmt::format("Guessing is not rejected ({}), which would take {} ({}).", p,
                                             region, side_in_words(report));
  const Interval& interval = cell.primary->interval;
  const bool beyond = (report.design.side == "greater" && interval.upper < cell.primary->chance) ||
                      (report.design.side == "less" && interval.lower > cell.primary->chance);
  if (beyond && report.complete) return text + beyond_the_plan(report, cell);
  return text + fmt::format(
                    " This does not show that the difference cannot be {}: {} correct is compatible with the "
                    "answers ({} interval).",
                    report.pseudo_haptic ? "noticed" : "felt", percent_range(interval),
                    short_percent(interval.level));
}

// A look that nobody planned has no alpha to spend.
std::string without_claim(const StudyReport& report, const CellResult& cell, const std::string& p) {
  const Interval& interval = cell.primary->interval;
  return fmt::format("{}: {} ({}), {} interval {}; {}.", primary_in_words(report.design), p,
                     report.design.side == "two-sided" ? "two-sided" : "one-sided: " + report.design.side,
                     short_percent(interval.level), percent_range(interval), kNoClaim);
}

std::string primary_sentence(const StudyReport& report, const CellResult& cell) {
  const std::string p = p_in_words(cell.primary->p.of(cell.primary->side));
  if (!report.complete && !report.look) return without_claim(report, cell, p);
  return rejects(cell.primary->critical, cell.correct) ? rejection(report, cell, p)
                                                       : no_rejection(report, cell, p);
}

double least_p(std::size_t n, Side side) {
  return std::ldexp(1.0, (side == Side::TwoSided ? 1 : 0) - static_cast<int>(std::min<std::size_t>(n, 1000)));
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

long answers_not_counted(const StudyReport& report) {
  long others = 0;
  for (const CellResult& cell : report.cells)
    if (cell.all) others += cell.all->trials - cell.trials;
  return others;
}

// What all answers give that are in the file, next to those that the plan counts.
std::string all_answers_sentence(const CellResult& cell) {
  if (!cell.all) return "";
  return fmt::format(" With everybody's answers, which is not planned, {} of {} are correct ({}).",
                     cell.all->correct, cell.all->trials,
                     percent(static_cast<double>(cell.all->correct) / static_cast<double>(cell.all->trials)));
}

std::string sample_sentence(const StudyReport& report) {
  long answers = 0;
  for (const CellResult& cell : report.cells) answers += cell.trials;
  std::string text = fmt::format("{} of {} planned {} completed the study; {} counted",
                                 report.complete_examinees, report.planned_examinees,
                                 report.run_mode == "simulated" ? "simulated examinees" : "examinees",
                                 answers == 1 ? "1 answer is" : fmt::format("{} answers are", answers));
  const long others = answers_not_counted(report);
  if (others > 0) {
    text += fmt::format(", those of the first {} to complete it; {} not", *report.sample,
                        others == 1 ? "1 other answer is" : fmt::format("{} other answers are", others));
  }
  const auto voided = static_cast<long>(report.voided.size());
  if (voided > 0)
    text += fmt::format(", {} not",
                        voided == 1 ? "1 voided trial is" : fmt::format("{} voided trials are", voided));
  text += ".";
  if (!report.design.question.empty()) text += fmt::format(" The question: \"{}\"", report.design.question);
  return text;
}

std::string looks_sentence(const StudyReport& report) {
  std::vector<std::string> looks;
  for (const int look : report.design.looks) looks.push_back(std::to_string(look));
  return fmt::format("The protocol plans looks when exactly {} examinees are complete; none is due now.",
                     listed(looks));
}

std::string first_taken(const StudyReport& report) {
  for (const LookEvent& look : report.planned_looks) {
    if (look.planned == report.look->number && !look.utc.empty())
      return fmt::format(" It was first taken on {}.", look.utc);
  }
  return "";
}

}  // namespace

std::string examinees_word(const StudyReport& report, long count) {
  const std::string kind = report.run_mode == "simulated" ? "simulated " : "";
  return counted(count, kind + "examinee", kind + "examinees");
}

std::string region_in_words(const CriticalNumber& critical) {
  std::string text;
  if (critical.at_most) text = fmt::format("{} or fewer", *critical.at_most);
  if (critical.at_least) {
    if (!text.empty()) text += ", or ";
    text += *critical.at_least == critical.trials ? fmt::format("all {}", critical.trials)
                                                  : fmt::format("{} or more", *critical.at_least);
    if (*critical.at_least == critical.trials) return text + " correct";
  }
  return text.empty() ? text : text + fmt::format(" correct of {}", critical.trials);
}

std::string primary_in_words(const StudyDesign& design) {
  return design.primary == "paired-comparison" ? "Exact binomial test"
                                               : "Exact randomisation test over the balanced orders";
}

std::string points_range(const Interval& interval) {
  if (std::isnan(interval.lower) || std::isnan(interval.upper)) return "none";
  const double lower = std::max(-1.0, interval.lower), upper = std::min(1.0, interval.upper);
  return fmt::format("{:+.1f} to {:+.1f}", 100 * lower, 100 * upper);
}

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

std::string comparison_summary(const StudyReport& report, const CellComparison& comparison) {
  const std::string pair = fmt::format("{} against {}: ", comparison.first, comparison.second);
  if (comparison.examinees == 0) return pair + "no complete examinee has answers counted under both.";
  const double points = 100 * comparison.mean_difference;
  std::string text =
      pair + (points == 0
                  ? std::string("on the average examinees have the same proportion correct under both")
                  : fmt::format("on the average an examinee's proportion correct is {:.1f} percentage "
                                "points {} with {}",
                                std::abs(points), points > 0 ? "higher" : "lower", comparison.first));
  if (!comparison.sign_flip) return text + ".";
  const Interval& interval = comparison.sign_flip->interval;
  text += std::isnan(interval.lower)
              ? std::string(" (the same for every examinee, so that no interval can be given).")
              : fmt::format(" ({} interval {}).", short_percent(interval.level), points_range(interval));
  const bool wilcoxon = comparison.planned == "wilcoxon" && comparison.signed_rank;
  const double p = wilcoxon ? comparison.signed_rank->p.two_sided : comparison.sign_flip->p.two_sided;
  const std::string named = fmt::format(
      "{}, two-sided {}", wilcoxon ? "Wilcoxon signed-rank" : "sign-flip permutation", p_in_words(p));
  if (!report.complete) return text + fmt::format(" By {}: {}.", named, kNoClaim);
  if (least_p(comparison.examinees, Side::TwoSided) > report.design.alpha) {
    return text + fmt::format(" With {} no difference can reach alpha {} ({}).",
                              examinees_word(report, static_cast<long>(comparison.examinees)),
                              report.design.alpha, named);
  }
  if (p <= report.design.alpha)
    return text + fmt::format(" The difference is larger than chance explains ({}).", named);
  return text +
         fmt::format(" A difference is not shown ({}), which does not show that there is none.", named);
}

std::vector<std::string> banners(const StudyReport& report) {
  std::vector<std::string> banners;
  if (report.run_mode == "simulated") {
    banners.push_back(
        "SIMULATED: no person took part. The answers are those of simulated observers; they say what the "
        "program's observers do, not what people feel.");
  }
  if (report.run_mode == "pilot") {
    banners.push_back(
        "PILOT: made to try out the procedure. It is no evidence for or against the hypothesis and is "
        "never pooled with a study.");
  }
  if (report.pseudo_haptic) {
    banners.push_back(
        fmt::format("PSEUDO-HAPTIC: no force reached the hand. The stimulus was carried by {}; the "
                    "results say nothing about touch and are never pooled with haptic ones.",
                    report.channel.empty() ? "a channel that the sessions do not name" : report.channel));
  }
  if (!report.complete && report.look) {
    banners.push_back(fmt::format(
        "PLANNED LOOK {} of {}: {} of {} planned examinees are complete. The numbers of correct answers that "
        "reject guessing are those of the alpha that this look may spend; p values and intervals do not know "
        "of the looks.{}",
        report.look->number, report.look->of, report.complete_examinees, report.planned_examinees,
        first_taken(report)));
  } else if (!report.complete) {
    banners.push_back(fmt::format(
        "{}: {} of {} planned examinees are complete.{}", report.withheld ? "NOT COMPLETE" : "INTERIM LOOK",
        report.complete_examinees, report.planned_examinees,
        report.withheld ? " No result is shown before the planned sample is reached."
                        : " The tests below were read before the planned sample was reached; to stop because "
                          "of them would make false positives more frequent than alpha."));
  }
  return banners;
}

std::vector<std::string> summary(const StudyReport& report) {
  std::vector<std::string> paragraphs{sample_sentence(report)};
  for (const CellResult& cell : report.cells) paragraphs.push_back(cell_summary(report, cell));
  for (const CellComparison& comparison : report.comparisons) {
    paragraphs.push_back(comparison_summary(report, comparison));
  }
  if (report.withheld) {
    if (!report.design.looks.empty()) paragraphs.push_back(looks_sentence(report));
    paragraphs.push_back(
        "Results are withheld until the planned sample is complete, so that nobody can stop the study when it "
        "happens to look well, and whoever leads the sittings knows no more than the examinees. An interim look "
        "has to be asked for (--interim), and is logged.");
  }
  return paragraphs;
}

}  // namespace palpate::analysis
