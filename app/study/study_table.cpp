#include "app/study/study_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "app/study/force_curves.hpp"
#include "app/study/look_log.hpp"
#include "base/files/sha256.hpp"
#include "base/text/counted.hpp"
#include "trials/study/answered_trials.hpp"
#include "trials/study/chain_parts.hpp"
#include "trials/study/clock_steps.hpp"
#include "trials/study/merged_part.hpp"
#include "trials/study/resumption.hpp"

namespace palpate::app {

analysis::StudyDesign design_of(const trials::Protocol& protocol) {
  analysis::StudyDesign design{
      .protocol_name = protocol.name,
      .protocol_sha256 = protocol.sha256,
      .protocol_text = protocol.text,
      .question = protocol.question,
      .task = std::string(protocol.task->name),
      .chance = protocol.task->chance,
      .correct_condition = protocol.conditions[protocol.correct].name,
      .trials_per_examinee_per_cell = protocol.trials_per_examinee_per_cell,
      .planned_examinees = protocol.planned_examinees,
      .procedure = std::string(protocol.procedure->name),
      .cell_order = std::string(to_string(protocol.cell_order)),
      .interval_order = std::string(to_string(protocol.interval_order)),
      .least_presses = protocol.exploration.least_presses,
      .most_presses = protocol.exploration.most_presses,
      .min_depth_m = protocol.exploration.min_depth,
      .max_time_s = protocol.exploration.max_time,
      .display_during_interval = std::string(trials::to_string(protocol.during_interval)),
      .feedback_s = protocol.feedback ? trials::kFeedbackTime : 0.0,
      .primary = std::string(to_string(protocol.analysis.primary)),
      .alpha = protocol.analysis.alpha,
      .side = std::string(to_string(protocol.analysis.side)),
      .adjust = std::string(trials::to_string(protocol.analysis.adjust)),
      .between_models = protocol.analysis.between_models.value_or("none"),
      .looks = protocol.analysis.looks,
      .spending = protocol.analysis.spending};
  for (const std::size_t condition : protocol.presented)
    design.conditions.push_back(protocol.conditions[condition].name);
  for (const trials::Factor& factor : protocol.factors) design.factors.push_back(factor.name);
  for (const trials::Cell& cell : protocol.cells) {
    analysis::DesignCell row{.name = cell.name};
    for (std::size_t f = 0; f < cell.levels.size(); ++f)
      row.levels.push_back(protocol.factors[f].levels[cell.levels[f]].name);
    design.cells.push_back(row);
  }
  return design;
}

namespace {

analysis::ReportedSession session_of(const std::string& protocol_sha256, const trials::SessionRow& session) {
  const trials::SessionFacts& facts = session.facts;
  return {.session = session.number,
          .examinee = facts.examinee,
          .run_mode = std::string(trials::to_string(facts.run_mode)),
          .protocol_sha256 = protocol_sha256,  // a study file holds one protocol
          .software_version = facts.software_version,
          .device = facts.device,
          .channel = facts.channel,
          .order_source = facts.seed ? fmt::format("seed {}", *facts.seed) : "operating system",
          .started_utc = session.started_utc,
          .pseudo_haptic = facts.pseudo_haptic,
          .finished = session.ended_utc.has_value(),
          .force_scale = facts.force_scale,
          .times_resumed = session.times_resumed};
}

analysis::IntervalRow interval_of(const trials::Protocol& protocol,
                                  const trials::PresentationRow& presentation) {
  analysis::IntervalRow row{.interval = presentation.interval,
                            .condition = protocol.conditions[presentation.condition].name,
                            .n_presses = presentation.exploration.presses,
                            .exploration_time_s = presentation.exploration.time,
                            .peak_force_n = presentation.exploration.peak_force,
                            .max_depth_m = presentation.exploration.max_depth,
                            .clamped_fraction = presentation.clamped_fraction};
  if (presentation.loop) {
    row.loop_rate_hz = presentation.loop->rate_hz;
    row.loop_p999_ms = presentation.loop->p999_ms;
    row.missed_cycles = presentation.loop->missed_cycles;
  }
  if (presentation.solve) {
    if (std::isfinite(presentation.solve->force_error_bound))
      row.force_error_bound_n = presentation.solve->force_error_bound;
    row.cycles_within_tolerance = presentation.solve->cycles_within_tolerance;
    row.cycles_at_cap = presentation.solve->cycles_at_cap;
  }
  return row;
}

// In which order things were written.
struct Written {
  trials::ChainParts chains;
  std::map<std::int64_t, std::int64_t> begun{};  // sitting -> the entry that it began with

  Written(const trials::StudyRow& study, const std::vector<trials::EventRow>& events)
      : chains(study, trials::merged_parts(events)) {
    for (const trials::EventRow& event : events)
      if (event.kind == trials::event_kind::kBegun && event.session) begun[*event.session] = event.entry;
  }
  analysis::ChainPlace place(std::int64_t entry) const {
    return {.chain = static_cast<std::size_t>(&chains.chain_of(entry) - chains.chains().data()),
            .entry = entry};
  }
};

std::vector<trials::ClockStep> clock_steps(const Written& written,
                                           const std::vector<trials::EventRow>& events,
                                           const std::vector<trials::AnsweredTrial>& answered) {
  std::map<std::int64_t, std::string> times;
  for (const trials::EventRow& event : events) times[event.entry] = event.utc;
  for (const trials::AnsweredTrial& trial : answered) times[trial.answer.entry] = trial.answer.committed_utc;
  return trials::clock_steps_back(times, written.chains);
}

// Which of a joined file's parts a sitting came with; their number for one that came after they were joined.
std::size_t part_of_session(const std::vector<trials::MergedPart>& parts, std::int64_t session) {
  std::size_t part = 0;
  for (std::int64_t last = 0; part < parts.size(); ++part)
    if (session <= (last += parts[part].sessions)) break;
  return part;
}

// The sittings, and where each stands in the table, by its id.
std::map<std::int64_t, std::size_t> add_sessions(const trials::StudyFile& study, const Written& written,
                                                 const std::vector<trials::MergedPart>& parts,
                                                 analysis::StudyTable& table) {
  std::map<std::int64_t, std::size_t> places;
  const auto events = study.events();
  for (const trials::SessionRow& session : study.sessions()) {
    places[session.id] = table.sessions.size();
    table.sessions.push_back(session_of(table.design.protocol_sha256, session));
    table.sessions.back().part = part_of_session(parts, session.id);
    table.sessions.back().later_versions = trials::versions_that_resumed(events, session.id);
    const auto begun = written.begun.find(session.id);
    if (begun != written.begun.end()) table.sessions.back().begun = written.place(begun->second);
  }
  return places;
}

analysis::TrialRow trial_of(const trials::Protocol& protocol, const trials::AnsweredTrial& answered,
                            std::size_t session) {
  const trials::Trial& trial = answered.drawn.trial;
  const trials::AnswerRow& answer = answered.answer;
  analysis::TrialRow row{.session = session,
                         .cell = trial.cell,
                         .block = trial.block,
                         .trial = trial.number,
                         .correct_answer = std::to_string(trial.correct_answer),
                         .response = std::to_string(answer.response),
                         .correct = answer.correct,
                         .response_time_s = answer.response_time,
                         .answered_utc = answer.committed_utc};
  row.voided = answered.void_reason.has_value();
  if (row.voided) row.void_reason = *answered.void_reason;
  for (const trials::PresentationRow& presentation : answered.intervals)
    row.intervals.push_back(interval_of(protocol, presentation));
  for (const trials::PresentationRow& presentation : answered.exposures)
    row.shown_in_vain.push_back(protocol.conditions[presentation.condition].name);
  return row;
}

analysis::FrozenPlan frozen_plan_of(const trials::EventRow& event, analysis::ChainPlace written) {
  const auto plan = nlohmann::json::parse(event.text, nullptr, false);
  const auto text = [&](const char* key) {
    const bool given = plan.is_object() && plan.contains(key) && plan[key].is_string();
    return given ? plan[key].get<std::string>() : std::string();
  };
  return {.part = written.chain,
          .sha256 = base::sha256_hex(event.text),
          .frozen_utc = event.utc,
          .written = written,
          .software_version = text("software_version")};
}

// The name of a part that the file was joined from, and a note of it.
void add_part(const trials::MergedPart& part, analysis::StudyTable& table) {
  const std::string name =
      fmt::format("the study file {}{}", part.file, part.site.empty() ? "" : " of the site " + part.site);
  table.parts.push_back(name);
  table.notes.push_back(fmt::format("Joined from {}: {}, receipt {}.", name,
                                    base::counted(part.sessions, "sitting", "sittings"),
                                    trials::to_string(part.receipt)));
}

}  // namespace

analysis::StudyTable read_study_table(const trials::StudyFile& study, bool curves) {
  const trials::Protocol& protocol = study.protocol();
  analysis::StudyTable table{.design = design_of(protocol)};
  const auto events = study.events();
  const auto parts = trials::merged_parts(events);
  const Written written(study.study(), events);
  for (const trials::EventRow& event : events) {
    if (event.kind == kPlanFrozen)
      table.frozen_plans.push_back(frozen_plan_of(event, written.place(event.entry)));
    if (auto look = look_of(event)) {
      look->written = written.place(event.entry);
      table.looks.push_back(*look);
    }
  }
  for (const trials::MergedPart& part : parts) add_part(part, table);
  const auto answered = trials::answered_trials(study);
  for (const trials::ClockStep& step : clock_steps(written, events, answered))
    table.notes.push_back(fmt::format(
        "While the study ran, {}; who counts goes by the chain's order, not by the clock.", in_words(step)));
  const auto places =
      add_sessions(study, written, parts, table);  // after the answers: one may begin meanwhile
  for (const trials::AnsweredTrial& trial : answered) {
    table.trials.push_back(trial_of(protocol, trial, places.at(trial.session->id)));
    table.trials.back().written = written.place(trial.answer.entry);
  }
  if (curves) add_curves(study, answered, table);
  return table;
}

}  // namespace palpate::app
