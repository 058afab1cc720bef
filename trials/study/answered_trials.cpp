#include "trials/study/answered_trials.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace palpate::trials {
namespace {

/// Where the trials of a sitting are found by number and draw, or its answers by number alone.
using PlacesOfDraws = std::map<std::pair<int, int>, std::size_t>;
using PlacesOfTrials = std::map<int, std::size_t>;

/// Adds the answers with their trials; those without one go apart.
PlacesOfTrials add_answers(const std::shared_ptr<const SessionRow>& session, SittingRows& rows,
                           const VoidReasons& reasons, JoinedSitting& joined) {
  PlacesOfDraws draws;
  for (std::size_t i = 0; i < rows.trials.size(); ++i)
    draws[{rows.trials[i].trial.number, rows.trials[i].draw}] = i;
  PlacesOfTrials places;
  for (AnswerRow& answer : rows.answers) {
    const auto drawn = draws.find({answer.trial, answer.draw});
    if (drawn == draws.end()) {
      joined.without_trial.push_back(std::move(answer));
      continue;
    }
    places[answer.trial] = joined.answered.size();
    AnsweredTrial& trial = joined.answered.emplace_back();
    trial.session = session;
    trial.drawn = rows.trials[drawn->second];
    const auto reason = reasons.find({session->id, answer.trial});
    if (reason != reasons.end()) trial.void_reason = reason->second;
    trial.answer = std::move(answer);
  }
  return places;
}

/// A presentation is what the answer was given to, unless a later one of its interval takes its place.
void add_presentation(AnsweredTrial& trial, PresentationRow presentation) {
  if (presentation.draw != trial.answer.draw || presentation.verdict != Verdict::Enough) {
    trial.exposures.push_back(std::move(presentation));
    return;
  }
  const auto at =
      std::ranges::lower_bound(trial.intervals, presentation.interval, {}, &PresentationRow::interval);
  if (at == trial.intervals.end() || at->interval != presentation.interval) {
    trial.intervals.insert(at, std::move(presentation));
    return;
  }
  std::swap(*at, presentation);
  trial.exposures.push_back(std::move(presentation));
}

JoinedSitting joined_sitting(const StudyFile& study, const SessionRow& session, const VoidReasons& reasons) {
  SittingRows rows;
  rows.answers = study.answers(session.id);  // first: the trial of each is there, though a sitting may go on
  rows.trials = study.trials(session.id);
  rows.presentations = study.presentations(session.id);
  JoinedSitting joined = join(session, std::move(rows), reasons);
  if (!joined.without_trial.empty())
    throw std::invalid_argument(
        "the study file is damaged: an answer has no trial; `palpate verify` tells more");
  return joined;
}

}  // namespace

VoidReasons void_reasons(const std::vector<EventRow>& events) {
  VoidReasons reasons;
  for (const EventRow& event : events)
    if (event.kind == event_kind::kVoided && event.session && event.trial)
      reasons[{*event.session, *event.trial}] = event.text;
  return reasons;
}

JoinedSitting join(const SessionRow& session, SittingRows rows, const VoidReasons& reasons) {
  JoinedSitting joined;
  const PlacesOfTrials places =
      add_answers(std::make_shared<const SessionRow>(session), rows, reasons, joined);
  for (PresentationRow& presentation : rows.presentations) {
    const auto place = places.find(presentation.trial);
    if (place == places.end())
      joined.unanswered.push_back(std::move(presentation));
    else
      add_presentation(joined.answered[place->second], std::move(presentation));
  }
  for (AnsweredTrial& trial : joined.answered) std::ranges::sort(trial.exposures, {}, &PresentationRow::id);
  return joined;
}

std::vector<AnsweredTrial> answered_trials(const StudyFile& study) {
  std::vector<AnsweredTrial> all;
  const VoidReasons reasons = void_reasons(study.events());
  for (const SessionRow& session : study.sessions())
    std::ranges::move(joined_sitting(study, session, reasons).answered, std::back_inserter(all));
  return all;
}

std::vector<Exposure> exposures(const StudyFile& study) {
  std::vector<Exposure> all;
  for (const SessionRow& session : study.sessions()) {
    JoinedSitting joined = joined_sitting(study, session, {});
    std::vector<PresentationRow> felt = std::move(joined.unanswered);
    for (AnsweredTrial& trial : joined.answered) std::ranges::move(trial.exposures, std::back_inserter(felt));
    std::ranges::sort(felt, {}, &PresentationRow::id);
    const auto shared = std::make_shared<const SessionRow>(session);
    for (PresentationRow& presentation : felt) all.push_back({shared, std::move(presentation)});
  }
  return all;
}

std::vector<PresentationRow> shown_for(const AnsweredTrial& trial) {
  std::vector<PresentationRow> shown = trial.intervals;
  std::ranges::copy_if(trial.exposures, std::back_inserter(shown), [&](const PresentationRow& presentation) {
    return presentation.draw == trial.answer.draw;
  });
  std::ranges::sort(shown, {}, &PresentationRow::id);
  return shown;
}

std::vector<PresentationRow> presentations_of(const std::vector<PresentationRow>& all,
                                              const DrawnTrial& drawn) {
  std::vector<PresentationRow> felt;
  std::ranges::copy_if(all, std::back_inserter(felt), [&](const PresentationRow& presentation) {
    return presentation.trial == drawn.trial.number && presentation.draw == drawn.draw;
  });
  return felt;
}

}  // namespace palpate::trials
