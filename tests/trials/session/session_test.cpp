#include "trials/session/session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <optional>
#include <set>
#include <stdexcept>

#include "base/clock/utc.hpp"
#include "tests/trials/support/protocols.hpp"
#include "tests/trials/support/sitting.hpp"
#include "trials/study/verify.hpp"

namespace palpate::trials {
namespace {

using testing::HasSubstr;

class SessionTest : public testing::Test {
 protected:
  /// A program that starts: the study is opened (again) and the sitting begun or resumed.
  Session& start(const SessionFacts& facts = test::facts_of("P01"), bool new_session = false) {
    kill();
    check_start(path_, protocol_, facts, new_session);
    study_.emplace(open_study(path_, protocol_, "0.1.0"));
    return session_.emplace(start_session(*study_, protocol_, facts, new_session));
  }
  /// A program that ends without a word: nothing is written, as by SIGKILL.
  void kill() {
    session_.reset();
    study_.reset();
  }
  std::string refusal(const SessionFacts& facts, bool new_session = false) {
    const std::string said =
        test::message_of<std::invalid_argument>([&] { check_start(path_, protocol_, facts, new_session); });
    StudyFile study = open_study(path_, protocol_, "0.1.0");
    EXPECT_EQ(
        test::message_of<std::invalid_argument>([&] { start_session(study, protocol_, facts, new_session); }),
        said);
    return said;
  }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "study.db";
  Protocol protocol_ = test::small_protocol(2);
  std::optional<StudyFile> study_;
  std::optional<Session> session_;
};

TEST_F(SessionTest, GoesFromIntervalToIntervalToQuestion) {
  Session& session = start();
  EXPECT_EQ(session.phase(), Phase::Ready);
  EXPECT_EQ(session.view().interval, 1);
  session.begin_interval();
  EXPECT_EQ(session.phase(), Phase::Interval);
  EXPECT_EQ(session.end_interval(test::press_to(test::kDeepEnough)), Verdict::Enough);
  EXPECT_EQ(session.phase(), Phase::Pause);
  EXPECT_EQ(session.view().interval, 2);
  session.begin_interval();
  session.end_interval(test::press_to(test::kDeepEnough));
  EXPECT_EQ(session.phase(), Phase::Question);
  session.answer(2, 0.7, base::utc_now());
  EXPECT_EQ(session.phase(), Phase::Ready);
  EXPECT_EQ(session.pending().size(), 3U);
}

TEST_F(SessionTest, PresentsTheStimuliThatWereDrawn) {
  Session& session = start();
  const Trial trial = session.trial();
  for (const std::size_t condition : trial.interval_condition) {
    EXPECT_EQ(session.stimulus(), stimulus_index(protocol_, trial.cell, condition));
    session.begin_interval();
    session.end_interval(test::press_to(test::kDeepEnough));
  }
}

TEST_F(SessionTest, ShowsAnIntervalAgainThatWasNotExploredEnough) {
  Session& session = start();
  session.begin_interval();
  EXPECT_EQ(session.end_interval(test::press_to(2e-3)), Verdict::TooShallow);
  EXPECT_EQ(session.phase(), Phase::Pause);
  EXPECT_EQ(session.view().interval, 1);
  test::feel_both(session);
  const auto shown = study_->presentations(session.row().id);
  ASSERT_EQ(shown.size(), 3U);
  EXPECT_EQ(shown[0].verdict, Verdict::TooShallow);
  EXPECT_EQ(shown[1].attempt, 2);
  EXPECT_EQ(shown[1].condition, shown[0].condition);
}

TEST_F(SessionTest, StoresEachAnswerAndTrace) {
  Session& session = start();
  const Trial trial = session.trial();
  test::feel_both(session);
  session.answer(trial.correct_answer, 0.75, "2003-12-03T09:31:00.000Z");
  const auto answers = study_->answers(session.row().id);
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_TRUE(answers[0].correct);
  EXPECT_EQ(answers[0].response_time, 0.75);
  EXPECT_EQ(answers[0].onset_utc, "2003-12-03T09:31:00.000Z");
  const auto shown = study_->presentations(session.row().id);
  EXPECT_EQ(study_->load_trace(shown[1].id), test::press_to(test::kDeepEnough).trace);
  EXPECT_NEAR(shown[1].exploration.peak_force, 0.4, 1e-6);  // 100 N/m times 4 mm
}

TEST_F(SessionTest, RefusesCallsOutOfTurn) {
  Session& session = start();
  EXPECT_THROW(session.answer(1, 0.5, base::utc_now()), std::logic_error);
  EXPECT_THROW(session.end_interval({}), std::logic_error);
  test::feel_both(session);
  EXPECT_THROW(session.begin_interval(), std::logic_error);
  EXPECT_THROW(session.stimulus(), std::logic_error);
  EXPECT_THROW(session.answer(3, 0.5, base::utc_now()), std::invalid_argument);
  EXPECT_THROW(session.answer(0, 0.5, base::utc_now()), std::invalid_argument);
}

TEST_F(SessionTest, EndsWithEveryTrialAnswered) {
  Session& session = start();
  test::answer_all(session);
  EXPECT_TRUE(session.pending().empty());
  EXPECT_EQ(session.view().phase, Phase::Finished);
  EXPECT_EQ(session.view().number, 0);
  EXPECT_EQ(session.view().questions, 4);
  EXPECT_TRUE(study_->sessions().at(0).ended_utc.has_value());
  EXPECT_TRUE(verify_study(path_, session.receipt()).problems.empty());
}

TEST_F(SessionTest, GoesOnAtTheFirstUnansweredTrialAfterAKill) {
  Session& before = start();
  test::feel_both(before);
  before.answer(1, 0.5, base::utc_now());
  const auto pending = before.pending();
  Session& after = start();
  EXPECT_TRUE(after.view().resumed);
  ASSERT_EQ(after.pending().size(), pending.size());
  for (std::size_t i = 0; i < pending.size(); ++i) EXPECT_EQ(after.pending()[i].trial, pending[i].trial);
  EXPECT_EQ(after.pending()[0].draw, 0);  // nothing of it had been felt
  EXPECT_EQ(study_->sessions().at(0).times_resumed, 1);
}

TEST_F(SessionTest, DrawsAnInterruptedTrialAgainAndLogsWhatWasFelt) {
  start().begin_interval();
  Session& after = start();
  EXPECT_EQ(after.pending()[0].draw, 1);
  EXPECT_EQ(after.phase(), Phase::Ready);
  EXPECT_EQ(after.view().interval, 1);
  test::answer_all(after);
  const auto shown = study_->presentations(after.row().id);
  ASSERT_EQ(shown.size(), 9U);  // four trials of two intervals, and the one that was cut off
  EXPECT_FALSE(shown[0].closed());
  EXPECT_EQ(study_->answers(after.row().id)[0].draw, 1);
  EXPECT_TRUE(verify_study(path_).problems.empty());
}

TEST_F(SessionTest, AKillBeforeTheAnswerLosesOnlyTheUnansweredTrial) {
  Session& before = start();
  test::feel_both(before);
  before.answer(1, 0.5, base::utc_now());
  test::feel_both(before);  // the question is open: the kill comes here
  Session& after = start();
  EXPECT_EQ(after.trial().number, 2);
  EXPECT_EQ(after.pending()[0].draw, 1);
  EXPECT_EQ(study_->answers(after.row().id).size(), 1U);
}

TEST_F(SessionTest, AnInterruptionWithinTheProgramIsLogged) {
  Session& session = start();
  session.begin_interval();
  session.interrupt(test::press_to(1e-3), "the page was closed");
  EXPECT_EQ(session.phase(), Phase::Ready);
  EXPECT_EQ(session.pending()[0].draw, 1);
  EXPECT_EQ(study_->presentations(session.row().id).at(0).verdict, Verdict::Interrupted);
  const auto events = study_->events();
  EXPECT_EQ(events.at(events.size() - 2).text, "the page was closed");
  EXPECT_EQ(events.back().kind, event_kind::kDrawnAgain);
  test::answer_all(session);
  EXPECT_TRUE(verify_study(path_).problems.empty());
}

// Over many sittings the second draw of an interrupted trial is a fair coin, whatever the first one was.
TEST_F(SessionTest, TheSecondDrawIsACoinOfItsOwn) {
  int changed = 0;
  constexpr int kExaminees = 100;
  for (int i = 0; i < kExaminees; ++i) {
    Session& session = start(test::facts_of("P" + std::to_string(100 + i)));
    const int before = session.trial().correct_answer;
    session.begin_interval();
    session.interrupt({}, "test");
    changed += session.trial().correct_answer != before ? 1 : 0;
  }
  EXPECT_NEAR(changed, kExaminees / 2, 25);  // five standard deviations
}

TEST_F(SessionTest, RefusesAFinishedExamineeUnlessTold) {
  test::answer_all(start());
  kill();
  EXPECT_THAT(refusal(test::facts_of("P01")), HasSubstr("has finished a study sitting"));
  EXPECT_EQ(start(test::facts_of("P01"), true).row().number, 2);
}

TEST_F(SessionTest, APilotDoesNotStandInForTheStudy) {
  test::answer_all(start(test::facts_of("P01", RunMode::Pilot)));
  const Session& session = start(test::facts_of("P01", RunMode::Study));
  EXPECT_EQ(session.row().number, 2);
  EXPECT_FALSE(session.view().resumed);
}

TEST_F(SessionTest, RefusesCodesThatReadLikeAnothers) {
  start();
  kill();
  EXPECT_THAT(refusal(test::facts_of("p1")), HasSubstr("reads like \"P01\""));
  EXPECT_THAT(refusal(test::facts_of("Mary Jones")), HasSubstr("never a name"));
}

// Two descriptors of one file exclude each other within a process as they do between two.
TEST_F(SessionTest, OneProgramLeadsSessionsInAStudy) {
  start();
  StudyFile second = open_study(path_, protocol_, "0.1.0");
  const std::string said =
      test::message_of<std::runtime_error>([&] { start_session(second, protocol_, test::facts_of("P01")); });
  EXPECT_EQ(said, path_.string() + ": another palpate is leading a session in this study (pid " +
                      std::to_string(::getpid()) + "); wait for it, or stop it");
  EXPECT_EQ(second.sessions().at(0).times_resumed, 0);
  kill();
  EXPECT_TRUE(start_session(second, protocol_, test::facts_of("P01")).view().resumed);
}

TEST_F(SessionTest, APersonAndASimulatedExamineeShareNoCode) {
  start(test::facts_of("S01", RunMode::Pilot));
  kill();
  EXPECT_THAT(refusal(test::facts_of("S01", RunMode::Simulated)), HasSubstr("is a person in this study"));
  start(test::facts_of("S02", RunMode::Simulated));
  kill();
  EXPECT_THAT(refusal(test::facts_of("S02")), HasSubstr("is a simulated examinee of this study"));
}

TEST_F(SessionTest, RefusesToGoOnWithAnotherSeedOrAnotherKindOfDevice) {
  start();
  kill();
  EXPECT_THAT(refusal(test::facts_of("P01", RunMode::Study, 2)), HasSubstr("was begun with --seed 1"));
  SessionFacts haptic = test::facts_of("P01");
  haptic.pseudo_haptic = false;
  EXPECT_THAT(refusal(haptic), HasSubstr("was begun with the device"));
}

TEST_F(SessionTest, ARefusedStartMakesNoFile) {
  EXPECT_THROW(check_start(path_, protocol_, test::facts_of("Mary Jones"), false), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(path_));
}

// What the page gets is the same whatever is presented, field by field.
TEST_F(SessionTest, TheViewTellsNothingOfTheStimulus) {
  std::set<std::tuple<Phase, int, int, std::string, std::string>> seen;
  std::set<std::size_t> stimuli;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Session& session = start(test::facts_of("P0" + std::to_string(seed), RunMode::Study, seed));
    const SessionView view = session.view();
    stimuli.insert(session.stimulus());
    seen.emplace(view.phase, view.interval, view.number, view.question, std::string(view.hint));
  }
  EXPECT_GT(stimuli.size(), 1U);  // else the test would show nothing
  EXPECT_EQ(seen.size(), 1U);
}

}  // namespace
}  // namespace palpate::trials
