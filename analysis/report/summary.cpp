#include "analysis/report/summary.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

long answers_not_counted(const StudyReport& report) {
  long others = 0;
  for (const CellResult& cell : report.cells)
    if (cell.all) others += cell.all->trials - cell.trials;
  return others;
}

std::string sample_sentence(const StudyReport& report) {
  long answers = 0;
  for (const CellResult& cell : report.cells) answers += cell.trials;
  const std::string kind = report.run_mode == "simulated" ? "planned simulated examinee" : "planned examinee";
  std::string text = fmt::format("{} of {} completed the study; {} counted", report.complete_examinees,
                                 counted(report.planned_examinees, kind, kind + "s"),
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
      return fmt::format(" It was first taken on {} UTC.", to_the_second(look.utc));
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

std::string points_range(const CellComparison& comparison, bool turned) {
  Interval interval = comparison.sign_flip->interval;
  if (turned) interval = {.lower = -interval.upper, .upper = -interval.lower};
  if (std::isnan(interval.lower) || std::isnan(interval.upper)) return "none";
  const double most = comparison.contrast.kind == Contrast::Kind::Interaction ? 2.0 : 1.0;
  const double lower = std::max(-most, interval.lower), upper = std::min(most, interval.upper);
  return fmt::format("{:+.1f} to {:+.1f}", 100 * lower + 0.0, 100 * upper + 0.0);
}

std::string sessions_in_words(const StudyReport& report) {
  const auto [first, last] = std::ranges::minmax(report.sessions, {}, &ReportedSession::started_utc);
  const auto finished = std::ranges::count_if(report.sessions, &ReportedSession::finished);
  return fmt::format("{}, of which {} finished, begun {} UTC.",
                     counted(std::ssize(report.sessions), "session", "sessions"),
                     counted(finished, "is", "are"),
                     first.started_utc == last.started_utc
                         ? "on " + to_the_second(first.started_utc)
                         : fmt::format("between {} and {}", to_the_second(first.started_utc),
                                       to_the_second(last.started_utc)));
}

double least_p(std::size_t examinees, Side side) {
  return std::ldexp(
      1.0, (side == Side::TwoSided ? 1 : 0) - static_cast<int>(std::min<std::size_t>(examinees, 1000)));
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
        "{}: {} of {} {} complete.{}", report.withheld ? "NOT COMPLETE" : "INTERIM LOOK",
        report.complete_examinees, counted(report.planned_examinees, "planned examinee", "planned examinees"),
        report.complete_examinees == 1 ? "is" : "are",
        report.withheld ? " No result is shown before the planned sample is reached."
                        : " The tests below were read before the planned sample was reached; to stop because "
                          "of them would make false positives more frequent than alpha."));
  }
  return banners;
}

std::vector<std::string> summary(const StudyReport& report) {
  std::vector<std::string> paragraphs{sample_sentence(report)};
  for (const CellResult& cell : report.cells) paragraphs.push_back(cell_summary(report, cell));
  const std::size_t planned =
      planned_contrasts(report.design);  // where there are any, the others are in the table
  for (std::size_t i = 0; i < report.comparisons.size(); ++i)
    if (planned == 0 || i < planned) paragraphs.push_back(comparison_summary(report, report.comparisons[i]));
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
