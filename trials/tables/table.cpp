#include "trials/tables/table.hpp"

#include <algorithm>
#include <map>

#include "trials/session/session_state.hpp"
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

/// Why a trial was voided, by session and trial; the last reason given counts.
std::map<std::pair<std::int64_t, int>, std::string> voided(const StudyFile& study) {
  std::map<std::pair<std::int64_t, int>, std::string> reasons;
  for (const EventRow& event : study.events())
    if (event.kind == event_kind::kVoided && event.session && event.trial)
      reasons[{*event.session, *event.trial}] = event.text;
  return reasons;
}

const DrawnTrial& drawn_for(const std::vector<DrawnTrial>& trials, const AnswerRow& answer) {
  const auto found = std::ranges::find_if(trials, [&](const DrawnTrial& drawn) {
    return drawn.trial.number == answer.trial && drawn.draw == answer.draw;
  });
  if (found == trials.end())
    throw std::invalid_argument(
        "the study file is damaged: an answer has no trial; `palpate verify` tells more");
  return *found;
}

/// Levels are missing with constant stimuli: the condition says what was presented.
std::vector<Value> presentation_row(const SessionRow& session, const PresentationRow& p) {
  constexpr std::size_t kMeasured = 8;
  std::vector<Value> row{session.facts.examinee,
                         number(session.number),
                         number(p.trial),
                         number(p.interval),
                         p.condition,
                         Value(),
                         Value()};
  if (!p.complete) {
    row.resize(row.size() + kMeasured);
    return row;
  }
  const std::vector<Value> measured{number(p.exploration.presses),
                                    p.exploration.time,
                                    p.exploration.peak_force,
                                    p.exploration.max_depth,
                                    p.clamped_fraction,
                                    p.loop ? Value(p.loop->rate_hz) : Value(),
                                    p.loop ? Value(p.loop->p999_ms) : Value(),
                                    p.loop ? number(p.loop->missed_cycles) : Value()};
  row.insert(row.end(), measured.begin(), measured.end());
  return row;
}

Value run_mode(const SessionRow& session) {
  return std::string(to_string(session.facts.run_mode));
}

}  // namespace

bool counted(const PresentationRow& p, const std::vector<AnswerRow>& answers) {
  return p.verdict == to_string(Verdict::Enough) &&
         std::ranges::any_of(answers, [&](const AnswerRow& answer) {
           return answer.trial == p.trial && answer.draw == p.draw;
         });
}

Table trial_table(const StudyFile& study) {
  const Protocol& design = study.protocol();
  Table table{.name = "trials", .columns = trial_columns(design)};
  const auto reasons = voided(study);
  for (const SessionRow& session : study.sessions()) {
    const auto trials = study.trials(session.id);
    for (const AnswerRow& answer : study.answers(session.id)) {
      const Trial& trial = drawn_for(trials, answer).trial;
      const auto reason = reasons.find({session.id, answer.trial});
      std::vector<Value> row{session.facts.examinee,
                             number(session.number),
                             number(trial.block),
                             number(trial.number),
                             run_mode(session),
                             std::string(design.task->name),
                             std::string(design.procedure->name)};
      for (std::size_t i = 0; i < design.factors.size(); ++i)
        row.push_back(plain_text(design.factors[i].levels[design.cells[trial.cell].levels[i]]));
      const std::vector<Value> rest{number(trial.correct_interval),
                                    number(answer.response),
                                    number(answer.correct ? 1 : 0),
                                    value_of(answer.response_time),
                                    answer.onset_utc,
                                    plain_text(session.facts.device),
                                    number(session.facts.pseudo_haptic ? 1 : 0),
                                    design.sha256,
                                    session.facts.software_version,
                                    number(reason != reasons.end() ? 1 : 0),
                                    reason != reasons.end() ? Value(plain_text(reason->second)) : Value()};
      row.insert(row.end(), rest.begin(), rest.end());
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

Table interval_table(const StudyFile& study) {
  Table table{.name = "intervals", .columns = interval_columns(study.protocol())};
  for (const SessionRow& session : study.sessions()) {
    const auto answers = study.answers(session.id);
    for (const PresentationRow& p : study.presentations(session.id))
      if (counted(p, answers)) {
        table.rows.push_back(presentation_row(session, p));
        table.rows.back().push_back(run_mode(session));
      }
  }
  return table;
}

Table exposure_table(const StudyFile& study) {
  Table table{.name = "exposures", .columns = exposure_columns(study.protocol())};
  for (const SessionRow& session : study.sessions()) {
    const auto answers = study.answers(session.id);
    for (const PresentationRow& p : study.presentations(session.id)) {
      if (counted(p, answers)) continue;
      std::vector<Value> row = presentation_row(session, p);
      row.push_back(number(p.draw));
      const bool whole = p.verdict == to_string(Verdict::Enough);
      row.push_back(whole || !p.complete ? std::string("the trial was cut off") : p.verdict);
      row.push_back(run_mode(session));
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

}  // namespace palpate::trials
