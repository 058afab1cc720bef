#include "trials/tables/codebook.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "trials/study/study_file.hpp"
#include "trials/tables/delimited.hpp"

namespace palpate::trials {
namespace {

/// A factor's key as a column: contact.model -> contact_model.
std::string column_name(std::string key) {
  std::ranges::replace_if(
      key, [](char c) { return !((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')); }, '_');
  return key;
}

Column flag(std::string name, std::string title, std::string yes, std::string no) {
  return {.name = std::move(name),
          .title = std::move(title),
          .description = fmt::format("1: {}; 0: {}", yes, no),
          .kind = Kind::Whole,
          .least = 0,
          .most = 1,
          .levels = {{"0", no}, {"1", yes}}};
}

Column measure(std::string name, std::string title, std::string description, std::string unit) {
  return {.name = std::move(name),
          .title = std::move(title),
          .description = std::move(description),
          .unit = std::move(unit),
          .kind = Kind::Real,
          .least = 0};
}

Column text(std::string name, std::string title, std::string description) {
  return {.name = std::move(name), .title = std::move(title), .description = std::move(description)};
}

Column missing_too(Column column) {
  column.may_be_missing = true;
  return column;
}

Column interval_number(const Protocol& protocol) {
  Column column = whole_column("interval", "Interval", "Number of the interval within the trial", 1);
  column.most = protocol.task->intervals;
  return column;
}

Column answer_number(const Protocol& protocol, std::string name, std::string title, std::string description) {
  Column column = whole_column(std::move(name), std::move(title), std::move(description), 1);
  column.most = static_cast<double>(protocol.task->choices.size());
  return column;
}

Column participant() {
  Column column = text("participant_id", "Examinee", "Code of the examinee; never a name");
  column.pattern = "[A-Za-z0-9-]{1,32}";
  return column;
}
Column sitting() {
  return whole_column("session_id", "Sitting", "Number of this examinee's sitting", 1);
}
Column question() {
  return whole_column("trial", "Trial", "Number of the question within the sitting", 1);
}

Column run_mode() {
  Column column =
      text("run_mode", "Run mode", "What the sitting was held for; only study sittings are results");
  for (const auto& [mode, meaning] :
       {std::pair{RunMode::Study, "counts as a result"}, std::pair{RunMode::Pilot, "tried the study out"},
        std::pair{RunMode::Practice, "the examinee practised"},
        std::pair{RunMode::Simulated, "answered by a simulated examinee: no person took part"}})
    column.levels.push_back({std::string(to_string(mode)), meaning});
  return column;
}

Column one_of(Column column, const std::string& value, const std::string& meaning) {
  column.levels = {{value, meaning}};
  return column;
}

std::string in_words(const std::vector<sim::Override>& changes) {
  std::string words;
  for (const sim::Override& change : changes)
    words += fmt::format("{}{} = {}", words.empty() ? "" : ", ", change.key, change.value);
  return words.empty() ? "the scene unchanged" : plain_text(words);
}

/// A level without a name of its own says by it what it is.
std::string in_words(const Factor& factor, const FactorLevel& level) {
  const bool named = level.overrides.size() != 1 || level.overrides[0].key != factor.name ||
                     level.overrides[0].value.find(level.name) == std::string::npos;
  return named ? in_words(level.overrides) : fmt::format("{} = {}", factor.name, plain_text(level.name));
}

Column of_factor(const Factor& factor) {
  Column column = text(column_name(factor.name), factor.name, "Level of the factor " + factor.name);
  for (const FactorLevel& level : factor.levels)
    column.levels.push_back({plain_text(level.name), in_words(factor, level)});
  return column;
}

Column of_condition(const Protocol& protocol) {
  Column column = text("condition", "Condition", "What was presented in the interval");
  for (const std::size_t presented : protocol.presented) {
    const Condition& condition = protocol.conditions[presented];
    column.levels.push_back({condition.name, in_words(condition.overrides)});
  }
  return column;
}

/// @param may_be_cut_off  presentations that never ended have nothing measured
std::vector<Column> presentation_columns(const Protocol& protocol, bool may_be_cut_off) {
  std::vector<Column> columns{participant(), sitting(), question(), interval_number(protocol),
                              of_condition(protocol)};
  Column proposed = missing_too(text("level_proposed", "Level proposed",
                                     "Level that the procedure proposed; n/a with constant stimuli"));
  Column presented = missing_too(
      text("level_presented", "Level presented", "Level that was presented; n/a with constant stimuli"));
  proposed.kind = presented.kind = Kind::Real;
  Column clamped = measure("clamped_fraction", "Share of cycles clamped",
                           "Share of cycles in which the device's limit cut the force", "");
  clamped.most = 1;
  std::vector<Column> measured{
      whole_column("n_presses", "Presses", "How often the finger went in", 0),
      measure("exploration_time_s", "Exploration time", "From onset to end of the interval", "s"),
      measure("peak_force_n", "Peak force", "Largest force on the finger", "N"),
      measure("max_depth_m", "Largest depth", "Deepest point in contact", "m"), clamped};
  for (Column& column : measured) column.may_be_missing = may_be_cut_off;
  const std::vector<Column> loop{
      measure("loop_rate_hz", "Rate of the haptic loop", "Mean rate; n/a where no loop ran in real time",
              "Hz"),
      measure("loop_p999_ms", "Jitter of the haptic loop",
              "99.9 % of cycles began no later than this after the one before", "ms"),
      whole_column("missed_cycles", "Missed cycles", "Cycles that the haptic loop missed", 0),
      measure("force_error_bound_n", "Bound of the force's error",
              "Largest bound, over the loop's cycles, of how far the force can be from the exact solution of "
              "the contact; empty where the contact model knows no bound",
              "N"),
      whole_column("cycles_within_tolerance", "Cycles ended within tolerance",
                   "Cycles whose solution ended early, within the scene's contact.tolerance", 0),
      whole_column("cycles_at_cap", "Cycles at the cap",
                   "Cycles whose solution ended at the cap on iterations", 0)};
  columns.push_back(proposed);
  columns.push_back(presented);
  columns.insert(columns.end(), measured.begin(), measured.end());
  for (const Column& column : loop) columns.push_back(missing_too(column));
  return columns;
}

}  // namespace

Column whole_column(std::string name, std::string title, std::string description, double least) {
  return {.name = std::move(name),
          .title = std::move(title),
          .description = std::move(description),
          .kind = Kind::Whole,
          .least = least};
}

std::string_view to_string(Kind kind) {
  switch (kind) {
    case Kind::Text:
      return "text";
    case Kind::Whole:
      return "whole number";
    case Kind::Real:
      return "number";
    case Kind::Utc:
      return "time, ISO 8601, UTC";
  }
  return "";
}

std::vector<Column> trial_columns(const Protocol& protocol) {
  std::vector<Column> columns{
      participant(),
      sitting(),
      whole_column("block", "Block", "Part of the sitting", 1),
      question(),
      run_mode(),
      one_of(text("task", "Task", "What was asked"), std::string(protocol.task->name),
             protocol.task->task_means(protocol)),
      one_of(text("procedure", "Procedure", "How levels were chosen"), std::string(protocol.procedure->name),
             std::string(protocol.procedure->meaning))};
  for (const Factor& factor : protocol.factors) columns.push_back(of_factor(factor));
  Column onset = text("onset_utc", "Onset of the question", "When the question appeared");
  onset.kind = Kind::Utc;
  Column hash = text("protocol_sha256", "Protocol", "SHA-256 of the protocol's text");
  hash.pattern = "[0-9a-f]{64}";
  const std::vector<Column> rest{
      answer_number(protocol, "correct_answer", "Correct answer",
                    protocol.task->correct_answer_means(protocol)),
      answer_number(protocol, "response", "Answer", std::string(protocol.task->response_means)),
      flag("correct", "Correct", "the answer is the correct one", "it is not"),
      missing_too(measure("response_time_s", "Response time",
                          "From the question's onset to the answer, by a monotonic clock; n/a for a "
                          "simulated examinee",
                          "s")),
      onset,
      text("device", "Device", "What the examinee pressed with"),
      flag("pseudo_haptic", "Pseudo-haptic", "no force reached the hand", "the device gave a force"),
      hash,
      text("software_version", "Software version", "Version of palpate that ran the sitting"),
      flag("voided", "Voided", "the answer does not count", "it counts"),
      missing_too(
          text("void_reason", "Why it was voided", "Why the answer does not count; n/a where it counts"))};
  columns.insert(columns.end(), rest.begin(), rest.end());
  return columns;
}

std::vector<Column> interval_columns(const Protocol& protocol) {
  std::vector<Column> columns = presentation_columns(protocol, false);
  columns.push_back(run_mode());
  return columns;
}

std::vector<Column> exposure_columns(const Protocol& protocol) {
  std::vector<Column> columns = presentation_columns(protocol, true);
  columns.push_back(
      whole_column("draw", "Draw", "How often the trial's order had been drawn again by then", 0));
  columns.push_back(text("why", "Why it did not count", "Why the presentation did not count"));
  columns.push_back(run_mode());
  return columns;
}

std::vector<Column> event_columns() {
  Column when = text("event_utc", "Time of the event", "When it was noted");
  when.kind = Kind::Utc;
  return {
      participant(),
      sitting(),
      missing_too(question()),
      text("event", "Event",
           "What was noted apart from answers: strategy (what the examinee wrote at the end), early key (a "
           "key pressed before the question), interrupted, resumed, or what another program added"),
      missing_too(text("event_text", "Text of the event",
                       "What was noted, in the examinee's or the program's words; free text can tell who "
                       "somebody is, so read it before it is shared")),
      when,
      run_mode()};
}

std::string pattern_of(const Column& column) {
  if (!column.pattern.empty() || column.levels.empty()) return column.pattern;
  std::string pattern;
  for (const Level& level : column.levels) {
    if (!pattern.empty()) pattern += '|';
    for (const char c : level.value) {
      if (std::string_view(".\\+*?()[]{}^$|/").find(c) != std::string_view::npos) pattern += '\\';
      pattern += c;
    }
  }
  return pattern;
}

}  // namespace palpate::trials
