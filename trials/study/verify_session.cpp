#include "trials/study/verify_session.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "base/files/sha256.hpp"
#include "trials/study/answered_trials.hpp"

namespace palpate::trials {
namespace {

void check_trace(const StudyFile::Stores& stores, const std::string& place, const PresentationRow& p,
                 FirstProblems& problems) {
  const auto stored = stores.presentations.trace(p.id);
  if (!stored) return problems.add("{}: its trace is missing", place);
  if (base::sha256_hex(stored->first) != p.trace_sha256)
    return problems.add("{}: its trace does not have the hash that is stored with it", place);
  try {
    const ExplorationSummary summary = summarise(decode(stored->first, stored->second));
    if (summary.presses != p.exploration.presses || summary.peak_force != p.exploration.peak_force ||
        summary.max_depth != p.exploration.max_depth || summary.time != p.exploration.time)
      problems.add("{}: presses, time, force or depth are not those of its trace", place);
  } catch (const std::invalid_argument& error) {
    problems.add("{}: {}", place, error.what());
  }
}

/// The trial against the plan that was drawn, and what was shown against the trial.
void check_answer(const Protocol& design, const std::string& place, const AnsweredTrial& answered,
                  FirstProblems& problems) {
  const Trial& trial = answered.drawn.trial;
  const auto& order = trial.interval_condition;
  const auto holds = std::ranges::find(order, design.correct);
  if (holds == order.end() || trial.correct_interval != 1 + (holds - order.begin()))
    problems.add("{}: the correct interval is not the one that held the correct condition", place);
  if (answered.answer.correct != (answered.answer.response == trial.correct_interval))
    problems.add("{}: whether the answer is correct does not follow from the order", place);
  for (int i = 0; i < std::ssize(order); ++i) {
    const bool shown = std::ranges::any_of(answered.intervals, [&](const PresentationRow& p) {
      return p.interval == i + 1 && p.condition == order[i];
    });
    if (!shown) problems.add("{}: interval {} was never shown as drawn and explored enough", place, i + 1);
  }
}

/// The events of one kind that are of the sitting (and of one of its trials), in the order of the chain.
std::vector<EventRow> events_of(const SittingInFile& in, std::string_view kind,
                                std::optional<int> trial = {}) {
  std::vector<EventRow> found;
  std::ranges::copy_if(in.events, std::back_inserter(found), [&](const EventRow& event) {
    return event.session == in.session.id && event.kind == kind && (!trial || event.trial == trial);
  });
  return found;
}

/// The first line in which the file is not what was hashed: "run mode=study, the file says run mode=pilot".
std::string difference(const std::string& hashed, const std::string& in_file) {
  std::istringstream then(hashed), now(in_file);
  std::string was, is;
  while (true) {
    const bool more = static_cast<bool>(std::getline(then, was));
    const bool goes_on = static_cast<bool>(std::getline(now, is));
    if (!more || !goes_on || was != is)
      return fmt::format("the chain says {}, the file {}", more ? was : "no more", goes_on ? is : "no more");
  }
}

/// Every trial of the protocol is drawn, each draw in its turn, and each cell as often as it is to be.
void check_plan(const Protocol& design, const std::string& who, const std::vector<DrawnTrial>& trials,
                FirstProblems& problems) {
  std::vector<int> in_cell(design.cells.size(), 0);
  std::map<int, int> draws;  // by trial
  for (const DrawnTrial& drawn : trials) {
    if (drawn.draw == 0) ++in_cell.at(drawn.trial.cell);
    int& next = draws[drawn.trial.number];
    if (drawn.draw != next)
      problems.add("{}, trial {}: its draw {} is missing", who, drawn.trial.number, next);
    next = drawn.draw + 1;
  }
  const int expected = trials_per_session(design);
  for (int number = 1; number <= expected; ++number)
    if (!draws.contains(number)) problems.add("{}, trial {}: is missing", who, number);
  for (const auto& [number, count] : draws)
    if (number < 1 || number > expected)
      problems.add("{}, trial {}: the protocol has {} trials", who, number, expected);
  for (std::size_t cell = 0; cell < in_cell.size(); ++cell)
    if (in_cell[cell] != design.trials_per_examinee_per_cell)
      problems.add("{}: {} trials of cell {}, the protocol has {}", who, in_cell[cell],
                   design.cells[cell].name, design.trials_per_examinee_per_cell);
}

/// The sitting's facts and the orders as first drawn are those that were hashed when it began.
void check_beginning(const SittingInFile& in, const std::string& who, const std::vector<DrawnTrial>& trials,
                     FirstProblems& problems) {
  const auto begun = events_of(in, event_kind::kBegun);
  if (begun.size() != 1)
    return problems.add("{}: {} events of its beginning in the chain, there must be one", who, begun.size());
  std::vector<DrawnTrial> plan;
  std::ranges::copy_if(trials, std::back_inserter(plan),
                       [](const DrawnTrial& drawn) { return drawn.draw == 0; });
  const SessionRow hashed = in.chains.as_hashed(in.session, begun[0].entry);
  const std::string text = begun_text(in.stores.design, hashed, plan);
  if (text != begun[0].text)
    problems.add("{}: its facts or orders are not those that it was begun with: {}", who,
                 difference(begun[0].text, text));
}

/// Each order that replaced another, and what was felt before, are those that were hashed then.
void check_redraws(const SittingInFile& in, const std::string& who, const std::vector<DrawnTrial>& trials,
                   const std::vector<PresentationRow>& presentations, FirstProblems& problems) {
  std::size_t matched = 0;
  for (const DrawnTrial& drawn : trials) {
    if (drawn.draw == 0) continue;
    const std::string place = fmt::format("{}, trial {}, draw {}", who, drawn.trial.number, drawn.draw);
    const auto events = events_of(in, event_kind::kDrawnAgain, drawn.trial.number);
    const auto at = static_cast<std::size_t>(drawn.draw - 1);
    if (at >= events.size()) {
      problems.add("{}: no event in the chain tells of it", place);
      continue;
    }
    ++matched;
    DrawnTrial before = drawn;
    --before.draw;
    const std::string text =
        drawn_again_text(in.stores.design, drawn, presentations_of(presentations, before));
    if (text != events[at].text)
      problems.add("{}: the order, or what was felt before it, was altered: {}", place,
                   difference(events[at].text, text));
  }
  if (matched != events_of(in, event_kind::kDrawnAgain).size())
    problems.add("{}: the chain tells of orders drawn again that are missing", who);
}

/// Checks each answer and gathers its text.
void check_answers(const SittingInFile& in, const std::string& who, SittingRows rows,
                   std::map<std::int64_t, std::string>& texts, FirstProblems& problems) {
  const Protocol& design = in.stores.design;
  const auto answers = std::ssize(rows.answers);
  const JoinedSitting joined = join(in.session, std::move(rows), {});
  for (const AnswerRow& answer : joined.without_trial)
    problems.add("{}, trial {}: is answered but was never drawn", who, answer.trial);
  for (const AnsweredTrial& answered : joined.answered) {
    const AnswerRow& answer = answered.answer;
    check_answer(design, fmt::format("{}, trial {}", who, answer.trial), answered, problems);
    texts[answer.entry] = canonical_text(design, in.chains.as_hashed(in.session, answer.entry),
                                         answered.drawn, shown_for(answered), answer);
  }
  if (in.session.ended_utc && answers != trials_per_session(design))
    problems.add("{}: has ended with {} answers of {}", who, answers, trials_per_session(design));
}

}  // namespace

void check_session(const SittingInFile& in, VerifyScope scope, std::map<std::int64_t, std::string>& texts,
                   VerifyReport& report, FirstProblems& problems) {
  const SessionRow& session = in.session;
  const std::string who = fmt::format("examinee {}, sitting {}", session.facts.examinee, session.number);
  const SittingRows rows{in.stores.trials.of_session(session.id),
                         in.stores.presentations.of_session(session.id),
                         in.stores.answers.of_session(session.id)};
  if (in.chains.lacks_site(session))
    problems.add("{}: its code does not begin with its site, {}", who,
                 in.chains.chain_of_session(session.id).part->site);
  check_plan(in.stores.design, who, rows.trials, problems);
  check_beginning(in, who, rows.trials, problems);
  check_redraws(in, who, rows.trials, rows.presentations, problems);
  check_answers(in, who, rows, texts, problems);
  if (scope == VerifyScope::Everything)
    for (const PresentationRow& p : rows.presentations)
      if (p.closed())
        check_trace(in.stores, fmt::format("{}, trial {}, interval {}", who, p.trial, p.interval), p,
                    problems);
  ++report.sessions;
  report.answers += static_cast<int>(rows.answers.size());
  report.presentations += static_cast<int>(rows.presentations.size());
}

}  // namespace palpate::trials
