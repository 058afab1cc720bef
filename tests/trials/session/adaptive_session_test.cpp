#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <optional>

#include "tests/trials/support/raw_sql.hpp"
#include "tests/trials/support/sitting.hpp"
#include "tests/trials/support/up_down.hpp"
#include "trials/session/session.hpp"
#include "trials/study/stores.hpp"
#include "trials/study/verify_session.hpp"

namespace palpate::trials {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Levels of a design with two cells, where the answers are right (true) or wrong.
std::vector<std::size_t> levels_after(const std::vector<bool>& answers) {
  const Protocol design = test::up_down_protocol();
  Generator generator = make_generator(1, "test");
  ProcedureState state = replay(test::kUpDown, design, {}, {});
  std::vector<std::size_t> levels;
  std::vector<Told> told;
  while (const auto level = test::kUpDown.next(state, generator)) {
    levels.push_back(level->cell);
    told.push_back({.level = *level, .answer = 1, .correct = answers.at(told.size())});
    state = after(test::kUpDown, state, told.back());
    EXPECT_EQ(replay(test::kUpDown, design, {}, told).memory, state.memory);
  }
  return levels;
}

TEST(Procedure, TheNextLevelDependsOnTheAnswers) {
  EXPECT_THAT(levels_after({true, true, false, false, true, true}), ElementsAre(0, 1, 1, 0, 0, 1));
  EXPECT_THAT(levels_after({false, false, false, false, false, false}), ElementsAre(0, 0, 0, 0, 0, 0));
}

class AdaptiveSession : public testing::Test {
 protected:
  void start() {
    session_.reset();
    study_.reset();
    study_.emplace(open_study(path_, protocol_, "0.1.0"));
    session_.emplace(start_session(*study_, protocol_, test::facts_of("P01")));
  }
  void answer(bool correct) {
    test::feel_both(*session_);
    const int right = session_->trial().correct_answer;
    session_->answer(correct ? right : 3 - right, 0.8, "2003-12-03T09:30:05.000Z");
  }
  /// What is wrong with the sitting. The staircase is in no list, so that the text in the file cannot name it.
  std::vector<std::string> problems() {
    StudyFile::Stores& stores = study_->stores();
    stores.design.procedure = &test::kUpDown;
    const auto events = stores.events.all();
    const auto sessions = stores.sessions.all();
    std::map<std::int64_t, std::string> texts;
    VerifyReport report;
    FirstProblems found;
    check_session({stores, ChainParts(stores.study, {}), events, sessions.front()}, VerifyScope::Everything,
                  texts, report, found);
    return found.take();
  }
  void tamper(const std::string& sql) {
    session_.reset();
    study_.reset();
    ASSERT_EQ(test::sql(path_, sql), "");
    study_.emplace(open_study(path_, protocol_, "0.1.0"));
  }
  std::vector<std::size_t> stored_levels() {
    std::vector<std::size_t> levels;
    for (const DrawnTrial& drawn : study_->trials(session_->row().id))
      if (drawn.draw == 0) levels.push_back(drawn.trial.cell);
    return levels;
  }
  int events_of(std::string_view kind) {
    int count = 0;
    for (const EventRow& event : study_->events()) count += event.kind == kind ? 1 : 0;
    return count;
  }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "study.db";
  Protocol protocol_ = test::up_down_protocol();
  std::optional<StudyFile> study_;
  std::optional<Session> session_;
};

TEST_F(AdaptiveSession, StoresEachTrialWithItsEventBeforeItIsShown) {
  start();
  EXPECT_THAT(stored_levels(), ElementsAre(0));
  EXPECT_EQ(events_of(event_kind::kDrawn), 1);
  answer(true);
  EXPECT_EQ(session_->phase(), Phase::Ready);
  EXPECT_THAT(stored_levels(), ElementsAre(0, 1));
  EXPECT_EQ(events_of(event_kind::kDrawn), 2);
  EXPECT_EQ(session_->trial(), study_->trials(session_->row().id).back().trial);
  EXPECT_EQ(session_->answered(), 1);
}

TEST_F(AdaptiveSession, EndsWhenTheProcedureAsksNoMore) {
  start();
  for (const bool correct : {true, true, false, false, true, true}) answer(correct);
  EXPECT_EQ(session_->phase(), Phase::Finished);
  EXPECT_THAT(stored_levels(), ElementsAre(0, 1, 1, 0, 0, 1));
  EXPECT_EQ(events_of(event_kind::kEnded), 1);
}

TEST_F(AdaptiveSession, GoesOnAfterAKillAsIfNothingHadHappened) {
  for (const bool correct : {true, true, false, false, true, true}) {
    start();
    answer(correct);
  }
  EXPECT_EQ(session_->phase(), Phase::Finished);
  EXPECT_THAT(stored_levels(), ElementsAre(0, 1, 1, 0, 0, 1));
  EXPECT_EQ(events_of(event_kind::kDrawn), 6);
}

TEST_F(AdaptiveSession, DrawsAnInterruptedTrialAgainAtItsLevel) {
  start();
  answer(true);
  session_->begin_interval();
  start();
  EXPECT_EQ(session_->pending().front().draw, 1);
  EXPECT_EQ(session_->trial().cell, 1U);
  EXPECT_EQ(session_->trial().number, 2);
  answer(false);
  EXPECT_THAT(stored_levels(), ElementsAre(0, 1, 0));
}

TEST_F(AdaptiveSession, IsVerifiedAsAnyOther) {
  start();
  for (const bool correct : {true, true, false, false, true, true}) answer(correct);
  session_->note("strategy", "none");
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(AdaptiveSession, ATrialAlteredBeforeItsAnswerIsFound) {
  start();
  answer(true);
  tamper("DROP TRIGGER trial_refuses_UPDATE; UPDATE trial SET cell = 'kuroda' WHERE number = 2");
  EXPECT_THAT(problems(),
              Contains(HasSubstr("trial 2: is not the one that was drawn: the chain says cell=sibille")));
}

TEST_F(AdaptiveSession, HasTheTrialsThatItsAnswersAskFor) {
  start();
  for (const bool correct : {true, false}) answer(correct);
  EXPECT_THAT(problems(), IsEmpty());
  tamper(
      "INSERT INTO trial SELECT session, 4, draw, block, cell, interval_order, correct_interval FROM trial "
      "WHERE number = 3");
  EXPECT_THAT(problems(), Contains(HasSubstr("trial 4: the protocol has 3 trials")));
  tamper("DROP TRIGGER trial_refuses_DELETE; DELETE FROM trial WHERE number = 3");
  EXPECT_THAT(problems(), Contains(HasSubstr("trial 3: is missing")));
}

TEST_F(AdaptiveSession, HasEndedOnlyWhenTheProcedureAsksNoMore) {
  start();
  for (const bool correct : {true, false}) answer(correct);
  session_->note(event_kind::kEnded, "not by the procedure");
  EXPECT_THAT(problems(), Contains(HasSubstr("has ended with 2 answers of 3")));
}

}  // namespace
}  // namespace palpate::trials
