#include "trials/session/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/clock/utc.hpp"
#include "base/files/sha256.hpp"
#include "trials/session/session_state.hpp"
#include "trials/study/answered_trials.hpp"
#include "trials/study/sitting_state.hpp"

namespace palpate::trials {
namespace {

/// Runs `write` as one transaction: all of it is on the disk when this returns, or nothing.
template <class Write>
void commit(Session::State& state, Write write) {
  guarded(state.study.path(), [&] {
    SQLite::Transaction transaction(state.stores.database, SQLite::TransactionBehavior::IMMEDIATE);
    write();
    transaction.commit();
  });
}

/// After a commit that added to the chain: it is not in the write-ahead log alone when this returns.
void settle(Session::State& state) {
  guarded(state.study.path(), [&] { state.stores.settle(); });
}

}  // namespace

void Session::State::expect(std::initializer_list<Phase> accepted, std::string_view call) const {
  if (std::ranges::find(accepted, phase) == accepted.end())
    throw std::logic_error(fmt::format("Session::{} called in phase {}", call, to_string(phase)));
}

std::size_t Session::State::condition() const {
  return pending.front().trial.interval_condition.at(interval - 1);
}

void Session::State::start_trial() {
  interval = 1;
  attempt = 0;
  phase = pending.empty() ? Phase::Finished : Phase::Ready;
}

void Session::State::store_end(const IntervalRecord& record, Verdict verdict) {
  PresentationRow end{.id = presentation};
  end.onset_utc = record.onset_utc;
  end.verdict = verdict;
  end.exploration = summarise(record.trace);
  end.clamped_fraction = record.clamped_fraction;
  end.loop = record.loop;
  end.solve = record.solve;
  end.samples = record.trace.size();
  const std::string encoded = encode(record.trace);
  end.trace_sha256 = base::sha256_hex(encoded);
  stores.presentations.end(end, encoded);
}

std::optional<DrawnTrial> Session::State::draw_next(const ProcedureState& told) {
  const int number = static_cast<int>(told.told) + 1;
  Generator generator = make_generator(row.facts.seed, order_purpose(row.facts.examinee, row.number, number));
  const std::optional<ChosenLevel> level = protocol.procedure->next(told, generator);
  if (!level) append_event(event_kind::kEnded, "every trial is answered");
  if (!level || told.told < told.ahead.size()) return std::nullopt;
  const DrawnTrial next{
      .session = row.id, .draw = 0, .trial = draw_trial(protocol, *level, number, generator)};
  stores.trials.add(next);
  stores.append({.session = row.id,
                 .trial = number,
                 .kind = std::string(event_kind::kDrawn),
                 .text = drawn_again_text(stores.design, next, {}),
                 .utc = base::utc_now()});
  return next;
}

DrawnTrial Session::State::draw_again() {
  DrawnTrial next = pending.front();
  ++next.draw;
  Generator generator = make_generator(
      row.facts.seed,
      fmt::format("{}, draw {}", order_purpose(row.facts.examinee, row.number, next.trial.number),
                  next.draw));
  protocol.task->redraw(protocol, next.trial, generator);
  stores.trials.add(next);
  const auto felt = presentations_of(stores.presentations.of_session(row.id), pending.front());
  append_event(event_kind::kDrawnAgain, drawn_again_text(stores.design, next, felt));
  return next;
}

void Session::State::append_event(std::string_view kind, std::string_view text) {
  EventRow event{.session = row.id};
  if (!pending.empty()) event.trial = pending.front().trial.number;
  event.kind = kind;
  event.text = text;
  event.utc = base::utc_now();
  stores.append(event);
}

Session::Session(std::unique_ptr<State> state) : state_(std::move(state)) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

Phase Session::phase() const {
  return state_->phase;
}
const Trial& Session::trial() const {
  return state_->pending.front().trial;
}
const std::vector<DrawnTrial>& Session::pending() const {
  return state_->pending;
}
int Session::answered() const {
  return static_cast<int>(state_->procedure.told);
}
const SessionRow& Session::row() const {
  return state_->row;
}
Receipt Session::receipt() const {
  return state_->study.receipt();
}

SessionView Session::view() const {
  const State& state = *state_;
  const bool done = state.phase == Phase::Finished;
  SessionView view{.phase = state.phase};
  view.interval = done || state.phase == Phase::Question ? 0 : state.interval;
  view.intervals = state.protocol.task->intervals;
  view.questions = trials_per_session(state.protocol);
  view.number = done ? 0 : state.pending.front().trial.number;
  view.question = state.protocol.question;
  view.choices = state.protocol.task->choices;
  view.hint = state.protocol.task->hint;
  view.spoken_hint = state.protocol.task->spoken_hint;
  view.resumed = state.resumed;
  view.run_mode = state.row.facts.run_mode;
  view.pseudo_haptic = state.row.facts.pseudo_haptic;
  return view;
}

std::size_t Session::stimulus() const {
  state_->expect({Phase::Ready, Phase::Pause, Phase::Interval}, "stimulus");
  return stimulus_index(state_->protocol, trial().cell, state_->condition());
}

void Session::begin_interval() {
  State& state = *state_;
  state.expect({Phase::Ready, Phase::Pause}, "begin_interval");
  const DrawnTrial& drawn = state.pending.front();
  PresentationRow row{.session = drawn.session, .trial = drawn.trial.number, .draw = drawn.draw};
  row.interval = state.interval;
  row.attempt = state.attempt + 1;
  row.condition = state.condition();
  row.begun_utc = base::utc_now();
  commit(state, [&] { state.presentation = state.stores.presentations.begin(row); });
  ++state.attempt;
  state.phase = Phase::Interval;
}

Verdict Session::end_interval(const IntervalRecord& record) {
  State& state = *state_;
  state.expect({Phase::Interval}, "end_interval");
  const Verdict verdict = judge(summarise(record.trace), state.protocol.exploration);
  commit(state, [&] { state.store_end(record, verdict); });
  state.phase = Phase::Pause;
  if (verdict != Verdict::Enough) return verdict;
  if (state.interval == state.protocol.task->intervals) {
    state.phase = Phase::Question;
  } else {
    ++state.interval;
    state.attempt = 0;
  }
  return verdict;
}

void Session::interrupt(const IntervalRecord& felt_so_far, std::string_view reason) {
  State& state = *state_;
  state.expect({Phase::Interval, Phase::Pause, Phase::Question}, "interrupt");
  DrawnTrial next;
  commit(state, [&] {
    if (state.phase == Phase::Interval) state.store_end(felt_so_far, Verdict::Interrupted);
    state.append_event(event_kind::kInterrupted, reason);
    next = state.draw_again();
  });
  state.pending.front() = next;
  state.start_trial();
  settle(state);
}

void Session::answer(int response, std::optional<double> response_time, std::string_view onset_utc) {
  State& state = *state_;
  state.expect({Phase::Question}, "answer");
  const Task& task = *state.protocol.task;
  if (response < 1 || response > std::ssize(task.choices))
    throw std::invalid_argument(fmt::format("answer: found {}, accepted: {}, 1 to {}", response,
                                            task.answer_is, task.choices.size()));
  const DrawnTrial& drawn = state.pending.front();
  AnswerRow row{
      .session = drawn.session, .trial = drawn.trial.number, .draw = drawn.draw, .response = response};
  row.correct = response == drawn.trial.correct_answer;
  row.response_time = response_time;
  row.onset_utc = onset_utc;
  const ProcedureState told = after(*state.protocol.procedure, state.procedure, told_of(drawn, row));
  std::optional<DrawnTrial> next;
  commit(state, [&] {
    row.committed_utc = base::utc_now();
    const auto felt = presentations_of(state.stores.presentations.of_session(row.session), drawn);
    const std::string text = canonical_text(state.stores.design, state.row, drawn, felt, row);
    state.stores.answers.add(state.stores.ledger.append(state.stores.study, text), row);
    next = state.draw_next(told);
  });
  state.procedure = told;
  state.pending.erase(state.pending.begin());
  if (next) state.pending.push_back(*next);
  state.start_trial();
  settle(state);
}

void Session::note(std::string_view kind, std::string_view text) {
  commit(*state_, [&] { state_->append_event(kind, text); });
  settle(*state_);
}

std::string_view to_string(Phase phase) {
  switch (phase) {
    case Phase::Ready:
      return "ready";
    case Phase::Interval:
      return "interval";
    case Phase::Pause:
      return "pause";
    case Phase::Question:
      return "question";
    case Phase::Finished:
      return "finished";
  }
  return "";
}

}  // namespace palpate::trials
