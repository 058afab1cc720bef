#include "trials/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "trials/session_state.hpp"

namespace palpate::trials {
namespace {

template <class Number>
Value value_of(const std::optional<Number>& value) {
  return value ? Value(*value) : Value();
}
Value number(std::int64_t value) {
  return value;
}

/// A factor's key as a column: contact.model -> contact_model.
std::string column_name(std::string key) {
  std::ranges::replace_if(
      key, [](char c) { return !((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')); }, '_');
  return key;
}

/// Why a trial was voided, by session and trial; the last reason given counts.
std::map<std::pair<std::int64_t, int>, std::string> voided(const StudyFile& study) {
  std::map<std::pair<std::int64_t, int>, std::string> reasons;
  for (const EventRow& event : study.events())
    if (event.kind == event_kind::kVoided && event.session && event.trial)
      reasons[{*event.session, *event.trial}] = event.text;
  return reasons;
}

std::vector<Column> trial_columns(const Protocol& design) {
  std::vector<Column> columns{{"participant_id", "code of the examinee"},
                              {"session_id", "number of this examinee's sitting, from 1"},
                              {"block", "part of the sitting, from 1"},
                              {"trial", "number of the question within the sitting, from 1"},
                              {"run_mode", "study, pilot, practice or simulated"},
                              {"task", "what was asked"},
                              {"procedure", "how levels were chosen"}};
  for (const Factor& factor : design.factors)
    columns.push_back({column_name(factor.key), "level of the factor " + factor.key});
  const std::vector<Column> rest{
      {"correct_answer", "number of the interval that held " + design.conditions[design.correct].name},
      {"response", "number of the interval that was chosen"},
      {"correct", "1 where response is correct_answer, else 0"},
      {"response_time_s", "from the question's onset to the answer, by a monotonic clock [s]"},
      {"onset_utc", "onset of the question, ISO 8601"},
      {"device", "what the examinee pressed with"},
      {"pseudo_haptic", "1 where no force reached the hand"},
      {"protocol_sha256", "hash of the protocol's text"},
      {"software_version", "of palpate"},
      {"voided", "1 where the answer does not count"},
      {"void_reason", "why"}};
  columns.insert(columns.end(), rest.begin(), rest.end());
  return columns;
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

std::vector<Column> presentation_columns() {
  return {{"participant_id", "code of the examinee"},
          {"session_id", "number of this examinee's sitting, from 1"},
          {"trial", "number of the question within the sitting, from 1"},
          {"interval", "number of the interval within the trial, from 1"},
          {"condition", "what was presented"},
          {"level_proposed", "level that the procedure proposed"},
          {"level_presented", "level that was presented"},
          {"n_presses", "how often the finger went in"},
          {"exploration_time_s", "from onset to end of the interval [s]"},
          {"peak_force_n", "largest force on the finger [N]"},
          {"max_depth_m", "deepest point in contact [m]"},
          {"clamped_fraction", "share of cycles in which the device's limit cut the force, 0 to 1"},
          {"loop_rate_hz", "mean rate of the haptic loop [Hz]"},
          {"loop_p999_ms", "99.9 % of cycles began no later than this after the one before [ms]"},
          {"missed_cycles", "cycles that the loop missed"}};
}

/// Levels are missing with constant stimuli: the condition says what was presented.
std::vector<Value> presentation_row(const SessionRow& session, const PresentationRow& p) {
  std::vector<Value> row{session.facts.examinee,
                         number(session.number),
                         number(p.trial),
                         number(p.interval),
                         p.condition,
                         Value(),
                         Value()};
  if (!p.complete) {
    row.resize(presentation_columns().size());
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

bool counted(const PresentationRow& p, const std::vector<AnswerRow>& answers) {
  return p.verdict == to_string(Verdict::Enough) &&
         std::ranges::any_of(answers, [&](const AnswerRow& answer) {
           return answer.trial == p.trial && answer.draw == p.draw;
         });
}

std::string cell_text(const Value& value) {
  if (std::holds_alternative<std::monostate>(value)) return "n/a";
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *whole);
  if (const auto* real = std::get_if<double>(&value)) return fmt::format("{}", *real);
  const std::string& text = std::get<std::string>(value);
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

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
                             std::string(to_string(session.facts.run_mode)),
                             design.task,
                             design.procedure};
      for (std::size_t i = 0; i < design.factors.size(); ++i)
        row.push_back(design.factors[i].levels[design.cells[trial.cell].levels[i]]);
      const std::vector<Value> rest{number(trial.correct_interval),
                                    number(answer.response),
                                    number(answer.correct ? 1 : 0),
                                    value_of(answer.response_time),
                                    answer.onset_utc,
                                    session.facts.device,
                                    number(session.facts.pseudo_haptic ? 1 : 0),
                                    design.sha256,
                                    session.facts.software_version,
                                    number(reason != reasons.end() ? 1 : 0),
                                    reason != reasons.end() ? Value(reason->second) : Value()};
      row.insert(row.end(), rest.begin(), rest.end());
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

Table interval_table(const StudyFile& study) {
  Table table{.name = "intervals", .columns = presentation_columns()};
  for (const SessionRow& session : study.sessions()) {
    const auto answers = study.answers(session.id);
    for (const PresentationRow& p : study.presentations(session.id))
      if (counted(p, answers)) table.rows.push_back(presentation_row(session, p));
  }
  return table;
}

Table exposure_table(const StudyFile& study) {
  Table table{.name = "exposures", .columns = presentation_columns()};
  table.columns.push_back({"draw", "how often the trial's order had been drawn again by then"});
  table.columns.push_back({"why", "why it did not count"});
  for (const SessionRow& session : study.sessions()) {
    const auto answers = study.answers(session.id);
    for (const PresentationRow& p : study.presentations(session.id)) {
      if (counted(p, answers)) continue;
      std::vector<Value> row = presentation_row(session, p);
      row.push_back(number(p.draw));
      const bool whole = p.verdict == to_string(Verdict::Enough);
      row.push_back(whole || !p.complete ? std::string("the trial was cut off") : p.verdict);
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

std::string to_csv(const Table& table) {
  std::string csv;
  for (std::size_t i = 0; i < table.columns.size(); ++i) csv += (i > 0 ? "," : "") + table.columns[i].name;
  csv += '\n';
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) csv += (i > 0 ? "," : "") + cell_text(row[i]);
    csv += '\n';
  }
  return csv;
}

}  // namespace palpate::trials
