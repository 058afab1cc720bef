#include "trials/study/verify_session.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "base/files/sha256.hpp"
#include "base/text/counted.hpp"
#include "trials/study/answered_trials.hpp"
#include "trials/study/sitting_state.hpp"

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
  if (trial.correct_answer != design.task->correct_answer(design, trial))
    problems.add("{}: the correct answer is not the one that follows from what was presented", place);
  if (answered.answer.correct != (answered.answer.response == trial.correct_answer))
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

/// How many questions a sitting has: those that are drawn ahead, and, where a procedure chooses by answers,
/// those that it asks for up to these answers.
int trials_asked(const Protocol& design, std::size_t ahead, ProcedureState state,
                 std::span<const Told> answers) {
  Generator any = make_generator(0, "how many, whatever is drawn");
  const Procedure& procedure = *design.procedure;
  for (const Told& told : answers) {
    if (!procedure.next(state, any)) break;
    state = after(procedure, std::move(state), told);
  }
  const std::size_t asked = state.told + (procedure.next(state, any) ? 1 : 0);
  return static_cast<int>(std::max(ahead, asked));
}

std::vector<int> count_by_cell(const Protocol& design, std::span<const ChosenLevel> levels) {
  std::vector<int> counts(design.cells.size(), 0);
  for (const ChosenLevel& level : levels) ++counts.at(level.cell);
  return counts;
}

/// Every trial that the procedure asks is drawn, each draw in its turn, and of those that were drawn ahead each
/// cell as often as it is to be. Returns how many trials there are to be.
int check_plan(const SittingInFile& in, const std::string& who, const SittingRows& rows,
               FirstProblems& problems) {
  const Protocol& design = in.stores.design;
  std::map<int, int> draws;  // by trial
  for (const DrawnTrial& drawn : rows.trials) {
    int& next = draws[drawn.trial.number];
    if (drawn.draw != next)
      problems.add("{}, trial {}: its draw {} is missing", who, drawn.trial.number, next);
    next = drawn.draw + 1;
  }
  Generator any = make_generator(0, "how often each, whatever is drawn");
  const auto to_be = design.procedure->draw_ahead(design, any);
  const auto ahead = levels_of(drawn_ahead(rows.trials, in.events));
  const int asked =
      trials_asked(design, to_be.size(), replay(*design.procedure, design, ahead, {}), told_by(rows));
  for (int number = 1; number <= asked; ++number)
    if (!draws.contains(number)) problems.add("{}, trial {}: is missing", who, number);
  for (const auto& [number, count] : draws)
    if (number < 1 || number > asked)
      problems.add("{}, trial {}: the protocol has {}", who, number, base::counted(asked, "trial", "trials"));
  const auto found = count_by_cell(design, ahead), accepted = count_by_cell(design, to_be);
  for (std::size_t cell = 0; cell < found.size(); ++cell)
    if (found[cell] != accepted[cell])
      problems.add("{}: {} of cell {}, the protocol has {}", who,
                   base::counted(found[cell], "trial", "trials"), design.cells[cell].name, accepted[cell]);
  return asked;
}

/// Each trial that was drawn after answers is the one that was hashed then.
void check_drawn_later(const SittingInFile& in, const std::string& who, const std::vector<EventRow>& drawn,
                       const std::vector<DrawnTrial>& trials, FirstProblems& problems) {
  for (const EventRow& event : drawn) {
    const std::string place = fmt::format("{}, trial {}", who, event.trial.value_or(0));
    const auto found = std::ranges::find_if(trials, [&](const DrawnTrial& trial) {
      return trial.trial.number == event.trial && trial.draw == 0;
    });
    if (found == trials.end()) {
      problems.add("{}: the chain tells of its draw, and it is missing", place);
      continue;
    }
    const std::string text = drawn_again_text(in.stores.design, *found, {});
    if (text != event.text)
      problems.add("{}: is not the one that was drawn: {}", place, difference(event.text, text));
  }
}

/// The sitting's facts and the orders as first drawn are those that were hashed when it began, or, where they
/// depend on answers, when they were drawn.
void check_beginning(const SittingInFile& in, const std::string& who, const std::vector<DrawnTrial>& trials,
                     FirstProblems& problems) {
  const auto begun = events_of(in, event_kind::kBegun);
  if (begun.size() != 1)
    return problems.add("{}: {} events of its beginning in the chain, there must be one", who, begun.size());
  check_drawn_later(in, who, events_of(in, event_kind::kDrawn), trials, problems);
  const SessionRow hashed = in.chains.as_hashed(in.session, begun[0].entry);
  const std::string text = begun_text(in.stores.design, hashed, drawn_ahead(trials, in.events));
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
    const std::size_t at = drawn.draw - 1;
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
void check_answers(const SittingInFile& in, const std::string& who, SittingRows rows, int asked,
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
  if (in.session.ended_utc && answers != asked)
    problems.add("{}: has ended with {} of {}", who, base::counted(answers, "answer", "answers"), asked);
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
  const int asked = check_plan(in, who, rows, problems);
  check_beginning(in, who, rows.trials, problems);
  check_redraws(in, who, rows.trials, rows.presentations, problems);
  check_answers(in, who, rows, asked, texts, problems);
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
