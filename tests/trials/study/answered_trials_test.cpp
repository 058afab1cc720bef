#include "trials/study/answered_trials.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "tests/trials/support/protocols.hpp"
#include "tests/trials/support/raw_sql.hpp"
#include "tests/trials/support/sitting.hpp"
#include "trials/study/merge.hpp"

namespace palpate::trials {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr const char* kOnset = "2003-12-03T09:30:05.000Z";

std::vector<std::int64_t> ids(const std::vector<PresentationRow>& presentations) {
  std::vector<std::int64_t> found;
  std::ranges::transform(presentations, std::back_inserter(found), &PresentationRow::id);
  return found;
}
std::vector<std::int64_t> ids(const std::vector<Exposure>& exposures) {
  std::vector<std::int64_t> found;
  for (const Exposure& exposure : exposures) found.push_back(exposure.presentation.id);
  return found;
}
std::vector<int> drawn_and_answered(const std::vector<AnsweredTrial>& trials) {
  std::vector<int> found;
  for (const AnsweredTrial& trial : trials) {
    EXPECT_EQ(trial.drawn.trial.number, trial.answer.trial);
    found.push_back(trial.answer.trial);
  }
  return found;
}

class AnsweredTrialsTest : public testing::Test {
 protected:
  AnsweredTrialsTest() : study_(open_study(path_, protocol_, "0.1.0")) {}

  Session begin(const std::string& examinee) {
    return start_session(study_, protocol_, test::facts_of(examinee));
  }
  static void answer(Session& session) {
    test::feel_both(session);
    session.answer(1, 0.8, kOnset);
  }
  void void_trial(const Session& session, int trial, const std::string& reason) {
    study_.add_event({.session = session.row().id, .trial = trial, .kind = "voided", .text = reason});
  }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "study.db";
  Protocol protocol_ = test::small_protocol(2);
  StudyFile study_;
};

TEST_F(AnsweredTrialsTest, AnEmptyStudyHasNone) {
  EXPECT_THAT(answered_trials(study_), IsEmpty());
  EXPECT_THAT(exposures(study_), IsEmpty());
}

TEST_F(AnsweredTrialsTest, EveryAnswerHasItsTrialItsSittingAndOnePresentationAnInterval) {
  Session session = begin("P01");
  test::answer_all(session);
  const auto trials = answered_trials(study_);
  EXPECT_THAT(drawn_and_answered(trials), ElementsAre(1, 2, 3, 4));
  for (const AnsweredTrial& trial : trials) {
    EXPECT_EQ(trial.session->facts.examinee, "P01");
    ASSERT_EQ(trial.intervals.size(), 2U);
    for (int i = 0; i < 2; ++i) {
      EXPECT_EQ(trial.intervals[i].interval, i + 1);
      EXPECT_EQ(trial.intervals[i].condition, trial.drawn.trial.interval_condition[i]);
    }
    EXPECT_THAT(trial.exposures, IsEmpty());
    EXPECT_FALSE(trial.void_reason);
  }
  EXPECT_THAT(exposures(study_), IsEmpty());
}

TEST_F(AnsweredTrialsTest, OfTwoReasonsForVoidingTheLastCounts) {
  Session session = begin("P01"), other = begin("P02");
  test::answer_all(session);
  test::answer_all(other);
  void_trial(session, 2, "alarm");
  void_trial(session, 2, "the door, not the alarm");
  const auto trials = answered_trials(study_);
  ASSERT_EQ(trials.size(), 8U);
  for (const AnsweredTrial& trial : trials) {
    const bool voided = trial.session->facts.examinee == "P01" && trial.answer.trial == 2;
    EXPECT_EQ(trial.void_reason,
              voided ? std::optional<std::string>("the door, not the alarm") : std::nullopt);
  }
}

TEST_F(AnsweredTrialsTest, AnIntervalThatWasRepeatedCountsOnce) {
  Session session = begin("P01");
  session.begin_interval();
  session.end_interval(test::press_to(1e-3));  // too shallow
  answer(session);
  const AnsweredTrial trial = answered_trials(study_).at(0);
  EXPECT_THAT(ids(trial.intervals), ElementsAre(2, 3));
  EXPECT_THAT(ids(trial.exposures), ElementsAre(1));
  EXPECT_THAT(ids(shown_for(trial)), ElementsAre(1, 2, 3));
  EXPECT_THAT(ids(exposures(study_)), ElementsAre(1));
}

TEST_F(AnsweredTrialsTest, ATrialDrawnAgainIsAnsweredAsItWasDrawnLast) {
  Session session = begin("P01");
  test::feel_both(session);
  session.interrupt({}, "test");  // the question was open: both intervals had been explored enough
  session.begin_interval();
  session.interrupt(test::press_to(1e-3), "test");
  answer(session);
  const AnsweredTrial trial = answered_trials(study_).at(0);
  EXPECT_EQ(trial.drawn.draw, 2);
  EXPECT_THAT(ids(trial.intervals), ElementsAre(4, 5));
  EXPECT_THAT(ids(trial.exposures), ElementsAre(1, 2, 3));
  EXPECT_EQ(trial.exposures[2].verdict, Verdict::Interrupted);
  EXPECT_THAT(ids(shown_for(trial)), ElementsAre(4, 5));
  EXPECT_THAT(ids(presentations_of(study_.presentations(1), study_.trials(1).at(0))), ElementsAre(1, 2));
}

TEST_F(AnsweredTrialsTest, WhatWasFeltOfAnUnansweredTrialIsAnExposure) {
  Session session = begin("P01");
  answer(session);
  test::feel_both(session);  // enough, and the question is open
  Session other = begin("P02");
  other.begin_interval();  // killed here
  EXPECT_THAT(drawn_and_answered(answered_trials(study_)), ElementsAre(1));
  const auto found = exposures(study_);
  EXPECT_THAT(ids(found), ElementsAre(3, 4, 5));
  EXPECT_EQ(found[0].session->facts.examinee, "P01");
  EXPECT_EQ(found[2].session->facts.examinee, "P02");
  EXPECT_FALSE(found[2].presentation.closed());
}

TEST_F(AnsweredTrialsTest, AJoinedFileHoldsThoseOfItsParts) {
  StudyFile second = open_study(folder_ / "second.db", protocol_, "0.1.0");
  Session session = begin("P01");
  test::answer_all(session);
  void_trial(session, 3, "alarm");
  Session other = start_session(second, protocol_, test::facts_of("Q01"));
  other.begin_interval();
  other.interrupt(test::press_to(1e-3), "test");
  test::answer_all(other);
  merge_studies(folder_ / "all.db", {{path_, "Osaka"}, {folder_ / "second.db", "Kyoto"}}, "0.1.0");

  const StudyFile all = read_study(folder_ / "all.db");
  const auto trials = answered_trials(all);
  EXPECT_THAT(drawn_and_answered(trials), ElementsAre(1, 2, 3, 4, 1, 2, 3, 4));
  for (std::size_t i = 0; i < trials.size(); ++i) {
    EXPECT_EQ(trials[i].session->facts.examinee, i < 4 ? "Osaka-P01" : "Kyoto-Q01");
    EXPECT_EQ(trials[i].void_reason.has_value(), i == 2);
    EXPECT_EQ(trials[i].intervals.size(), 2U);
  }
  const auto found = exposures(all);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].session->facts.examinee, "Kyoto-Q01");
}

TEST_F(AnsweredTrialsTest, AnAnswerWithoutATrialIsRefused) {
  Session session = begin("P01");
  test::answer_all(session);
  ASSERT_EQ(
      test::sql(path_, "DROP TRIGGER answer_refuses_UPDATE; UPDATE answer SET draw = 7 WHERE trial = 2"), "");
  const std::string said = test::message_of<std::invalid_argument>([&] { answered_trials(study_); });
  EXPECT_EQ(said, "the study file is damaged: an answer has no trial; `palpate verify` tells more");
  EXPECT_EQ(test::message_of<std::invalid_argument>([&] { exposures(study_); }), said);
}

/// Rows as a sitting, or a damaged file, may hold them: trials drawn up to three times, presentations of any
/// of them and of others, answers to draws that are there or not.
SittingRows any_rows() {
  constexpr int kTrials = 4, kDraws = 3, kIntervals = 3;
  const auto below = [](int end) { return *rc::gen::inRange(0, end); };
  SittingRows rows;
  for (int number = 1; number <= kTrials; ++number) {
    for (int draw = 0, draws = below(kDraws + 1); draw < draws; ++draw)
      rows.trials.push_back({.session = 1, .draw = draw, .trial = {.number = number}});
    if (below(2) == 1)
      rows.answers.push_back({.entry = number, .session = 1, .trial = number, .draw = below(kDraws)});
  }
  for (int id = 1, end = 1 + below(40); id < end; ++id) {
    PresentationRow presentation{.id = id, .session = 1, .trial = 1 + below(kTrials), .draw = below(kDraws)};
    presentation.interval = 1 + below(kIntervals);
    if (below(5) > 0) presentation.verdict = below(2) == 0 ? Verdict::Enough : Verdict::TooShallow;
    rows.presentations.push_back(presentation);
  }
  return rows;
}

/// Whether `p` is what `answer` was given to: no later one of its interval was explored enough.
bool naively_counted(const SittingRows& rows, const AnswerRow& answer, const PresentationRow& p) {
  const auto enough = [&](const PresentationRow& other) {
    return other.trial == answer.trial && other.draw == answer.draw && other.verdict == Verdict::Enough;
  };
  return enough(p) && std::ranges::none_of(rows.presentations, [&](const PresentationRow& other) {
           return enough(other) && other.interval == p.interval && other.id > p.id;
         });
}

RC_GTEST_PROP(JoinProperty, AgreesWithLookingAtEveryPair, ()) {
  const SittingRows rows = any_rows();
  const VoidReasons reasons{{{1, *rc::gen::inRange(1, 5)}, "alarm"}, {{2, 1}, "another sitting's"}};
  const JoinedSitting joined = join({.id = 1}, rows, reasons);
  std::size_t next = 0, astray = 0;
  std::vector<int> answered;
  for (const AnswerRow& answer : rows.answers) {
    const bool is_drawn = std::ranges::any_of(rows.trials, [&](const DrawnTrial& drawn) {
      return drawn.trial.number == answer.trial && drawn.draw == answer.draw;
    });
    if (!is_drawn) {
      RC_ASSERT(joined.without_trial.at(astray++).entry == answer.entry);
      continue;
    }
    answered.push_back(answer.trial);
    const AnsweredTrial& trial = joined.answered.at(next++);
    RC_ASSERT(trial.answer.entry == answer.entry);
    RC_ASSERT(trial.drawn.trial.number == answer.trial && trial.drawn.draw == answer.draw);
    RC_ASSERT(trial.void_reason.has_value() == reasons.contains({1, answer.trial}));
    std::vector<std::int64_t> counted, others, shown;
    for (const PresentationRow& p : rows.presentations) {
      if (p.trial != answer.trial) continue;
      (naively_counted(rows, answer, p) ? counted : others).push_back(p.id);
      if (p.draw == answer.draw) shown.push_back(p.id);
    }
    RC_ASSERT(std::ranges::is_sorted(trial.intervals, std::less_equal<>(), &PresentationRow::interval));
    std::vector<std::int64_t> intervals = ids(trial.intervals);
    std::ranges::sort(intervals);
    RC_ASSERT(intervals == counted);
    RC_ASSERT(ids(trial.exposures) == others);
    RC_ASSERT(ids(shown_for(trial)) == shown);
  }
  RC_ASSERT(joined.answered.size() == next && joined.without_trial.size() == astray);
  std::vector<std::int64_t> unanswered;
  for (const PresentationRow& p : rows.presentations)
    if (std::ranges::find(answered, p.trial) == answered.end()) unanswered.push_back(p.id);
  RC_ASSERT(ids(joined.unanswered) == unanswered);
}

}  // namespace
}  // namespace palpate::trials
