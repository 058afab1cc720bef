#include "trials/tables/table.hpp"

#include <algorithm>
#include <cmath>

#include "trials/tables/delimited.hpp"

namespace palpate::trials {
namespace {

template <class Number>
Value value_of(const std::optional<Number>& value) {
  return value ? Value(*value) : Value();
}
Value number(std::int64_t value) {
  return value;
}

/// Levels are missing with constant stimuli: the condition says what was presented.
std::vector<Value> presentation_row(const Protocol& design, const SessionRow& session,
                                    const PresentationRow& p) {
  constexpr std::size_t kMeasured = 11;
  std::vector<Value> row{session.facts.examinee,
                         number(session.number),
                         number(p.trial),
                         number(p.interval),
                         design.conditions.at(p.condition).name,
                         Value(),
                         Value()};
  if (!p.closed()) {
    row.resize(row.size() + kMeasured);
    return row;
  }
  const std::vector<Value> measured{
      number(p.exploration.presses),
      p.exploration.time,
      p.exploration.peak_force,
      p.exploration.max_depth,
      p.clamped_fraction,
      p.loop ? Value(p.loop->rate_hz) : Value(),
      p.loop ? Value(p.loop->p999_ms) : Value(),
      p.loop ? number(p.loop->missed_cycles) : Value(),
      p.solve && std::isfinite(p.solve->force_error_bound) ? Value(p.solve->force_error_bound) : Value(),
      p.solve ? number(p.solve->cycles_within_tolerance) : Value(),
      p.solve ? number(p.solve->cycles_at_cap) : Value()};
  row.insert(row.end(), measured.begin(), measured.end());
  return row;
}

Value run_mode(const SessionRow& session) {
  return std::string(to_string(session.facts.run_mode));
}

/// Of a trial that was cut off everything is in vain, what was explored enough as well.
std::string why_not_counted(const PresentationRow& p) {
  if (!p.verdict || p.verdict == Verdict::Enough) return "the trial was cut off";
  return std::string(to_string(*p.verdict));
}

std::vector<Value> answer_row(const Protocol& design, const AnsweredTrial& answered) {
  const SessionRow& session = *answered.session;
  const Trial& trial = answered.drawn.trial;
  const AnswerRow& answer = answered.answer;
  std::vector<Value> row{session.facts.examinee,
                         number(session.number),
                         number(trial.block),
                         number(trial.number),
                         run_mode(session),
                         std::string(design.task->name),
                         std::string(design.procedure->name)};
  for (std::size_t i = 0; i < design.factors.size(); ++i)
    row.push_back(plain_text(design.factors[i].levels[design.cells[trial.cell].levels[i]].name));
  const std::vector<Value> rest{number(trial.correct_answer),
                                number(answer.response),
                                number(answer.correct ? 1 : 0),
                                value_of(answer.response_time),
                                answer.onset_utc,
                                plain_text(session.facts.device),
                                number(session.facts.pseudo_haptic ? 1 : 0),
                                design.sha256,
                                session.facts.software_version,
                                number(answered.void_reason ? 1 : 0),
                                answered.void_reason ? Value(plain_text(*answered.void_reason)) : Value()};
  row.insert(row.end(), rest.begin(), rest.end());
  return row;
}

/// Told by the other tables, or of the chain's alone.
bool told_elsewhere(std::string_view kind) {
  return kind == event_kind::kBegun || kind == event_kind::kDrawn || kind == event_kind::kDrawnAgain ||
         kind == event_kind::kEnded || kind == event_kind::kVoided;
}

}  // namespace

Table trial_table(const Protocol& design, const std::vector<AnsweredTrial>& answered) {
  Table table{.name = "trials", .columns = trial_columns(design)};
  for (const AnsweredTrial& trial : answered) table.rows.push_back(answer_row(design, trial));
  return table;
}

Table interval_table(const Protocol& design, const std::vector<AnsweredTrial>& answered) {
  Table table{.name = "intervals", .columns = interval_columns(design)};
  for (const AnsweredTrial& trial : answered)
    for (const PresentationRow& presentation : trial.intervals) {
      table.rows.push_back(presentation_row(design, *trial.session, presentation));
      table.rows.back().push_back(run_mode(*trial.session));
    }
  return table;
}

Table exposure_table(const Protocol& design, const std::vector<Exposure>& exposures) {
  Table table{.name = "exposures", .columns = exposure_columns(design)};
  for (const auto& [session, presentation] : exposures) {
    std::vector<Value> row = presentation_row(design, *session, presentation);
    row.push_back(number(presentation.draw));
    row.push_back(why_not_counted(presentation));
    row.push_back(run_mode(*session));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table event_table(const std::vector<SessionRow>& sessions, const std::vector<EventRow>& events) {
  Table table{.name = "events", .columns = event_columns()};
  for (const EventRow& event : events) {
    const auto session = std::ranges::find_if(
        sessions, [&](const SessionRow& row) { return event.session && *event.session == row.id; });
    if (session == sessions.end() || told_elsewhere(event.kind)) continue;
    table.rows.push_back({session->facts.examinee, number(session->number),
                          event.trial ? number(*event.trial) : Value(), plain_text(event.kind),
                          plain_text(event.text), event.utc, run_mode(*session)});
  }
  return table;
}

}  // namespace palpate::trials
