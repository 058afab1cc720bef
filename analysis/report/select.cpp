#include "analysis/report/select.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

std::string sitting(const ReportedSession& session) {
  return fmt::format("examinee {}, session {}", session.examinee, session.session);
}

[[noreturn]] void refuse(const std::string& message) {
  throw std::invalid_argument(message);
}

void validate_design(const StudyDesign& design) {
  if (design.task != "2IFC") refuse(fmt::format("task is '{}'; this version reports on: 2IFC", design.task));
  const bool coin = design.interval_order == "coin" && design.primary == "paired-comparison";
  const bool balanced = design.interval_order == "balanced" && design.primary == "order-randomisation";
  if (!coin && !balanced) {
    refuse(
        fmt::format("the primary test is '{}' and the order of intervals '{}'; this version knows "
                    "paired-comparison for independent coin flips ('coin') and order-randomisation for "
                    "balanced orders ('balanced'): neither test holds for the other order",
                    design.primary, design.interval_order));
  }
  if (design.between_models != "none" && design.between_models != "sign-flip" &&
      design.between_models != "wilcoxon") {
    refuse(fmt::format("cells are compared by '{}'; this version knows: sign-flip, wilcoxon, none",
                       design.between_models));
  }
  if (design.cells.empty()) refuse("the design has no cell");
  require_level(design.alpha, "alpha");
  side_from_name(design.side);
}

void validate_trial(const StudyTable& table, const TrialRow& trial) {
  if (trial.session >= table.sessions.size() || trial.cell >= table.design.cells.size()) {
    refuse(fmt::format("trial {} belongs to a session or cell that the study does not have", trial.trial));
  }
  const bool coherent = trial.correct && (trial.correct_answer == "1" || trial.correct_answer == "2") &&
                        (trial.response == "1" || trial.response == "2") &&
                        *trial.correct == (trial.response == trial.correct_answer);
  if (coherent || trial.voided) return;
  refuse(
      fmt::format("{}, trial {}: answer '{}' with correct answer '{}' contradicts what is recorded as "
                  "{}; a two-interval trial has answers 1 and 2",
                  sitting(table.sessions[trial.session]), trial.trial, trial.response, trial.correct_answer,
                  !trial.correct ? "without truth" : (*trial.correct ? "correct" : "wrong")));
}

std::string run_mode_of(const StudyTable& table, const ReportOptions& options) {
  std::set<std::string> found;
  for (const ReportedSession& session : table.sessions) found.insert(session.run_mode);
  const std::string modes = listed({found.begin(), found.end()});
  if (found.empty()) refuse("the study holds no session yet: there is nothing to report");
  if (options.run_mode && *options.run_mode == "practice") {
    refuse("run mode is 'practice': practice is never reported; accepted: study, pilot, simulated");
  }
  if (options.run_mode) {
    if (found.contains(*options.run_mode)) return *options.run_mode;
    refuse(fmt::format("the study holds no session of run mode '{}'; found: {}", *options.run_mode, modes));
  }
  found.erase("practice");
  if (found.size() == 1) return *found.begin();
  if (found.empty()) refuse("the study holds practice sessions only, and practice is never reported");
  refuse(
      fmt::format("the study holds sessions of several run modes, which are never pooled: {}; name one with "
                  "--run-mode",
                  modes));
}

// Sessions of one run mode must still be of one kind to be counted together.
void validate_pool(const StudyTable& table, const std::vector<bool>& chosen) {
  const ReportedSession* first = nullptr;
  for (std::size_t i = 0; i < table.sessions.size(); ++i) {
    if (!chosen[i]) continue;
    const ReportedSession& session = table.sessions[i];
    if (session.protocol_sha256 != table.design.protocol_sha256) {
      refuse(
          fmt::format("{} was run under protocol {}, the study's is {}: different protocols are not "
                      "pooled",
                      sitting(session), session.protocol_sha256, table.design.protocol_sha256));
    }
    if (first == nullptr) first = &session;
    if (session.pseudo_haptic != first->pseudo_haptic || session.channel != first->channel) {
      refuse(
          fmt::format("{} ({}{}) and {} ({}{}) do not present the same stimulus: haptic and "
                      "pseudo-haptic sessions, or different channels, are never pooled",
                      sitting(*first), first->pseudo_haptic ? "pseudo-haptic, " : "haptic, ",
                      first->pseudo_haptic ? first->channel : first->device, sitting(session),
                      session.pseudo_haptic ? "pseudo-haptic, " : "haptic, ",
                      session.pseudo_haptic ? session.channel : session.device));
    }
  }
}

}  // namespace

void validate(const StudyTable& table) {
  validate_design(table.design);
  for (const TrialRow& trial : table.trials) validate_trial(table, trial);
  for (const ForceCurve& curve : table.curves) {
    if (curve.cell >= table.design.cells.size() || curve.depth_m.size() != curve.mean_force_n.size() ||
        (!curve.deviation_n.empty() && curve.deviation_n.size() != curve.depth_m.size())) {
      refuse("a force curve has columns of different lengths, or a cell that the study does not have");
    }
  }
}

Selection select(const StudyTable& table, const ReportOptions& options) {
  Selection selection{.run_mode = run_mode_of(table, options)};
  std::map<std::string, std::size_t> index;
  for (const ReportedSession& session : table.sessions) {
    const bool chosen = session.run_mode == selection.run_mode;
    selection.sessions.push_back(chosen);
    if (chosen && index.try_emplace(session.examinee, index.size()).second) {
      selection.examinees.push_back(session.examinee);
    }
    selection.examinee_of.push_back(chosen ? index.at(session.examinee) : 0);
  }
  validate_pool(table, selection.sessions);
  for (const TrialRow& trial : table.trials) {
    if (!selection.sessions[trial.session]) continue;
    (trial.voided ? selection.voided : selection.trials).push_back(&trial);
  }
  return selection;
}

}  // namespace palpate::analysis
