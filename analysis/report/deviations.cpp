#include "analysis/report/deviations.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "analysis/report/verdict.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

void add_sample(const StudyReport& report, std::vector<std::string>& found) {
  if (report.complete_examinees == report.planned_examinees || (report.look && !report.complete)) return;
  found.push_back(fmt::format("{} complete, {} planned{}.",
                              counted(report.complete_examinees, "examinee is", "examinees are"),
                              counted(report.planned_examinees, "was", "were"),
                              report.sample ? "; the tests count those who completed first" : ""));
}

void add_looks(const StudyReport& report, std::vector<std::string>& found) {
  const std::size_t looks = report.interim_looks.size();
  if (looks == 0) return;
  found.push_back(
      fmt::format("The results were looked at {} before the planned sample was complete, without being "
                  "planned.",
                  looks == 1 ? "once" : fmt::format("{} times", looks)));
}

void add_sessions(const StudyReport& report, std::vector<std::string>& found) {
  const auto unfinished = std::ranges::count_if(
      report.sessions, [](const ReportedSession& session) { return !session.finished; });
  if (unfinished > 0) {
    found.push_back(fmt::format("{} not finished.", counted(unfinished, "session was", "sessions were")));
  }
  if (report.sessions.size() > report.examinees.size()) {
    found.push_back(fmt::format("{} sat {} sessions.",
                                counted(std::ssize(report.examinees), "examinee", "examinees"),
                                report.sessions.size()));
  }
  const auto voided = static_cast<long>(report.voided.size());
  if (voided > 0) found.push_back(fmt::format("{} voided.", counted(voided, "trial was", "trials were")));
}

void add_versions(const StudyReport& report, std::vector<std::string>& found) {
  std::set<std::string> versions;
  for (const ReportedSession& session : report.sessions) {
    versions.insert(session.software_version);
    versions.insert(session.later_versions.begin(), session.later_versions.end());
  }
  for (const FrozenPlan& plan : report.frozen_plans) versions.insert(plan.software_version);
  versions.erase("");
  if (versions.size() < 2) return;
  found.push_back(fmt::format("The program's version changed on the way: {}.",
                              listed(std::vector<std::string>(versions.begin(), versions.end()))));
}

void add_plans(const StudyReport& report, std::vector<std::string>& found) {
  std::set<std::string> hashes;
  for (const FrozenPlan& plan : report.frozen_plans) hashes.insert(plan.sha256);
  if (hashes.size() > 1) found.push_back("The parts froze analysis plans that are not the same.");
}

bool begun_before(const StudyReport& report, const FrozenPlan& plan) {
  return std::ranges::any_of(report.sessions, [&](const ReportedSession& session) {
    return session.part == plan.part &&
           came_before(session.begun, session.started_utc, plan.written, plan.frozen_utc);
  });
}

/// What was frozen, and in a joined file in which of its parts; and where nothing was.
void add_frozen(const StudyReport& report, std::vector<std::string>& words) {
  if (report.frozen_plans.empty()) {
    words.push_back(
        "No analysis plan was frozen. The protocol, which names the primary test, alpha and the sample, was "
        "stored with the first session and cannot be changed since.");
    return;
  }
  for (const FrozenPlan& plan : report.frozen_plans)
    words.push_back(
        fmt::format("The analysis plan was frozen in {} on {} UTC (SHA-256 {}){}.",
                    part_in_words(report, plan.part), to_the_second(plan.frozen_utc), plan.sha256,
                    begun_before(report, plan) ? ", after the first of these sessions had begun" : ""));
  for (std::size_t part = 0; part < report.parts.size(); ++part)
    if (std::ranges::find(report.frozen_plans, part, &FrozenPlan::part) == report.frozen_plans.end())
      words.push_back(fmt::format("No analysis plan was frozen in {}.", part_in_words(report, part)));
}

std::string adjusted_in_words(const StudyDesign& design) {
  if (design.adjust == "none") return "";
  return fmt::format(", p adjusted over the cells after {}", adjustment_in_words(design.adjust));
}

std::string comparisons_in_words(const StudyDesign& design) {
  switch (planned_contrasts(design)) {
    case 0:
      return "no comparison between cells";
    case 1:
      return fmt::format("between the levels of {}: {}", factors_in_words(design), design.between_models);
    default:
      return fmt::format("main effects and interaction of {}: {}", factors_in_words(design),
                         design.between_models);
  }
}

}  // namespace

std::string part_in_words(const StudyReport& report, std::size_t part) {
  if (report.parts.empty()) return "the study file";
  return part < report.parts.size() ? report.parts[part] : "the joined file";
}

std::vector<std::string> plan_in_words(const StudyReport& report) {
  const StudyDesign& design = report.design;
  std::vector<std::string> words;
  add_frozen(report, words);
  words.push_back(
      fmt::format("Planned: {}; primary test {}, alpha {}, side {}{}; {}{}.",
                  counted(design.planned_examinees, "examinee", "examinees"), design.primary, design.alpha,
                  design.side, adjusted_in_words(design), comparisons_in_words(design),
                  design.looks.empty()
                      ? "; one look, at the end"
                      : fmt::format("; {}, {} spending", counted(std::ssize(design.looks), "look", "looks"),
                                    design.spending)));
  for (const LookEvent& look : report.planned_looks) {
    if (look.utc.empty()) continue;
    words.push_back(fmt::format("Planned look {} of {} was first taken on {} UTC.", look.planned,
                                design.looks.size(), to_the_second(look.utc)));
  }
  return words;
}

std::vector<std::string> deviations(const StudyReport& report) {
  std::vector<std::string> found;
  add_sample(report, found);
  add_looks(report, found);
  add_sessions(report, found);
  add_versions(report, found);
  add_plans(report, found);
  return found;
}

}  // namespace palpate::analysis
