#include "analysis/report/sentences.hpp"

#include <fmt/core.h>

#include "analysis/report/deviations.hpp"
#include "analysis/report/limits.hpp"
#include "analysis/report/method_section.hpp"
#include "analysis/report/summary.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {

void write_sentences(const std::vector<std::string>& notes, StudyReport& report) {
  const bool simulated = report.run_mode == "simulated";
  const std::string people = simulated ? "simulated examinees" : "people";
  report.banners = banners(report);
  report.summary = summary(report);
  const std::string why =
      report.design.interval_order == "coin"
          ? fmt::format(
                "A fair coin decided each order, so an answer that owes nothing to the stimulus is correct with "
                "probability {}, whoever gives it and however often.",
                chance_in_words(report.design.chance))
          : std::string(
                "The orders were balanced and drawn at random, so for answers that owe nothing to the stimulus "
                "every order that could have been drawn is as likely as the one that was; the answers are held "
                "fixed.");
  report.pooled_claim = fmt::format(
      "The pooled test asks whether anything but guessing is in the answers. {} A rejection says that "
      "somebody told the conditions apart; it does not say how many do.",
      why);
  report.people_claim = fmt::format(
      "The examinee-level test counts each examinee once. A rejection says that {} like these answer "
      "better than by chance on the average; it does not say that every one of them does.",
      people);
  report.comparison_claim = fmt::format(
      "Cells are compared within examinees, never trial by trial, because trials under different cells "
      "are not pairs. A rejection says that {} like these do better under one of them on the average.",
      people);
  if (!report.complete) {
    const std::string not_yet = fmt::format(" It is read when the sample is complete: {}.", kNoClaim);
    report.people_claim += not_yet;
    report.comparison_claim += not_yet;
  }
  report.plan = plan_in_words(report);
  report.deviations = deviations(report);
  report.method = method_section(report);
  report.limits = limits(report, notes);
}

}  // namespace palpate::analysis
