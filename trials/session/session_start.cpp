#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/clock/utc.hpp"
#include "trials/session/session_state.hpp"
#include "trials/study/answered_trials.hpp"
#include "trials/study/examinee_code.hpp"
#include "trials/study/resumption.hpp"
#include "trials/study/sitting_state.hpp"
#include "trials/study/verify.hpp"

namespace palpate::trials {
namespace {

std::optional<SessionRow> find_unfinished(const std::vector<SessionRow>& sessions,
                                          const SessionFacts& facts) {
  const auto found = std::ranges::find_if(sessions.rbegin(), sessions.rend(), [&](const SessionRow& session) {
    return session.facts.examinee == facts.examinee && session.facts.run_mode == facts.run_mode;
  });
  return found == sessions.rend() || found->ended_utc ? std::nullopt : std::optional(*found);
}

void check_resumable(const SessionRow& unfinished, const SessionFacts& facts) {
  const auto refuse = [&](const std::string& what) {
    throw std::invalid_argument(
        fmt::format("examinee {}: the unfinished sitting {}; accepted: the same again, or a new sitting "
                    "(--new-session)",
                    facts.examinee, what));
  };
  if (unfinished.facts.seed != facts.seed)
    refuse(unfinished.facts.seed ? fmt::format("was begun with --seed {}", *unfinished.facts.seed)
                                 : std::string("was begun without a seed"));
  if (unfinished.facts.observer != facts.observer) refuse("was begun with another observer");
  if (unfinished.facts.pseudo_haptic != facts.pseudo_haptic)
    refuse(fmt::format("was begun with the device \"{}\"", unfinished.facts.device));
}

}  // namespace

void check_not_shared(const SessionRow& session, std::string_view examinee, RunMode run_mode) {
  const bool simulated = session.facts.run_mode == RunMode::Simulated;
  if (session.facts.examinee != examinee || simulated == (run_mode == RunMode::Simulated)) return;
  throw std::invalid_argument(
      simulated ? fmt::format("examinee {}: is a simulated examinee of this study; accepted: another code, "
                              "or another study file",
                              examinee)
                : fmt::format("examinee {}: is a person in this study, and a simulated examinee of that code "
                              "would be taken for them; accepted: another study file",
                              examinee));
}

namespace {

/// What start_session() refuses, given the sittings that the file holds.
void check_against(const std::vector<SessionRow>& sessions, const SessionFacts& facts, bool new_session) {
  check_examinee_code(facts.examinee);
  std::vector<std::string> known;
  bool finished = false;
  for (const SessionRow& session : sessions) {
    check_not_shared(session, facts.examinee, facts.run_mode);
    known.push_back(session.facts.examinee);
    finished |= session.facts.examinee == facts.examinee && session.facts.run_mode == facts.run_mode &&
                session.ended_utc.has_value();
  }
  check_not_near(facts.examinee, known);
  if (new_session) return;
  if (const auto unfinished = find_unfinished(sessions, facts))
    check_resumable(*unfinished, facts);
  else if (finished)
    throw std::invalid_argument(
        fmt::format("examinee {}: has finished a {} sitting in this study; accepted: another examinee, or "
                    "--new-session for one more sitting",
                    facts.examinee, to_string(facts.run_mode)));
}

/// The procedure's state, made anew from what was drawn ahead and answered.
ProcedureState replayed(const StudyFile::Stores& stores, const Protocol& protocol, std::int64_t session) {
  const SittingRows sitting{.trials = stores.trials.of_session(session),
                            .answers = stores.answers.of_session(session)};
  return replay(*protocol.procedure, protocol, levels_of(drawn_ahead(sitting.trials, stores.events.all())),
                told_by(sitting));
}

/// The last draw of each trial that has no answer yet, in order.
std::vector<DrawnTrial> unanswered(const StudyFile::Stores& stores, std::int64_t session) {
  std::vector<DrawnTrial> pending;
  const auto answers = stores.answers.of_session(session);
  for (const DrawnTrial& drawn : stores.trials.of_session(session)) {
    const bool answered = std::ranges::find(answers, drawn.trial.number, &AnswerRow::trial) != answers.end();
    if (answered) continue;
    if (!pending.empty() && pending.back().trial.number == drawn.trial.number)
      pending.back() = drawn;
    else
      pending.push_back(drawn);
  }
  return pending;
}

}  // namespace

void Session::State::begin(const SessionFacts& facts, const std::vector<SessionRow>& earlier) {
  row.facts = facts;
  row.number = 1 + static_cast<int>(std::ranges::count_if(earlier, [&](const SessionRow& session) {
                 return session.facts.examinee == facts.examinee;
               }));
  row.started_utc = base::utc_now();
  row.id = stores.sessions.add(row);
  Generator generator = make_generator(facts.seed, order_purpose(facts.examinee, row.number));
  std::vector<Trial> plan = draw_plan(protocol, generator);
  procedure = replay(*protocol.procedure, protocol, levels_of(plan), {});
  for (Trial& trial : plan) {
    pending.push_back({.session = row.id, .draw = 0, .trial = std::move(trial)});
    stores.trials.add(pending.back());
  }
  // Into the chain before anything is asked: an order can no more be altered before its answer than after.
  stores.append({.session = row.id,
                 .trial = {},
                 .kind = std::string(event_kind::kBegun),
                 .text = begun_text(stores.design, row, pending),
                 .utc = row.started_utc});
  if (const auto first = draw_next(procedure)) pending.push_back(*first);
}

void Session::State::resume(const SessionRow& unfinished, const SessionFacts& now) {
  row = unfinished;
  resumed = true;
  pending = unanswered(stores, row.id);
  procedure = replayed(stores, protocol, row.id);
  append_event(event_kind::kResumed, resumed_text(now.software_version, now.machine));
  // Whatever was felt of the trial that was cut off must not help with its answer.
  if (!presentations_of(stores.presentations.of_session(row.id), pending.front()).empty())
    pending.front() = draw_again();
}

void check_start(const std::filesystem::path& path, const Protocol& protocol, const SessionFacts& facts,
                 bool new_session) {
  check_examinee_code(facts.examinee);
  check_study(path, protocol);
  if (!std::filesystem::exists(path)) return;
  require_whole(path);
  check_against(read_study(path).sessions(), facts, new_session);
}

Session start_session(StudyFile& study, const Protocol& protocol, const SessionFacts& facts,
                      bool new_session) {
  study.lock_for_sessions();
  auto state = std::unique_ptr<Session::State>(new Session::State{study, study.stores(), protocol});
  guarded(study.path(), [&] {
    SQLite::Transaction transaction(study.stores().database, SQLite::TransactionBehavior::IMMEDIATE);
    const auto sessions = study.stores().sessions.all();
    check_against(sessions, facts, new_session);
    const auto unfinished = new_session ? std::nullopt : find_unfinished(sessions, facts);
    if (unfinished)
      state->resume(*unfinished, facts);
    else
      state->begin(facts, sessions);
    transaction.commit();
    study.stores().settle();
  });
  return Session(std::move(state));
}

}  // namespace palpate::trials
