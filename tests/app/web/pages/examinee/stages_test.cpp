#include "app/web/pages/examinee/stages.hpp"

#include <gtest/gtest.h>

#include <initializer_list>

namespace palpate::app {
namespace {

using trials::Phase;

constexpr std::initializer_list<Stage> kStages = {Stage::Welcome, Stage::Gesture,  Stage::Trial,
                                                  Stage::Again,   Stage::Feedback, Stage::Thanks,
                                                  Stage::End,     Stage::Fault};
constexpr std::initializer_list<Phase> kPhases = {Phase::Ready, Phase::Interval, Phase::Pause,
                                                  Phase::Question, Phase::Finished};

TEST(Stages, LeadFromWelcomeIntoTheFirstInterval) {
  EXPECT_EQ(onward_from(Stage::Welcome, Phase::Ready), Onward::ToGesture);
  EXPECT_EQ(onward_from(Stage::Gesture, Phase::Ready), Onward::ToTrial);
  EXPECT_EQ(onward_from(Stage::Trial, Phase::Ready), Onward::IntoInterval);
}

TEST(Stages, LeadBackIntoTheTrialAfterWhatInterruptedIt) {
  EXPECT_EQ(onward_from(Stage::Again, Phase::Pause), Onward::IntoInterval);
  EXPECT_EQ(onward_from(Stage::Fault, Phase::Ready), Onward::ToTrial);
}

// Nobody can go on past an interval, a pause or a question, nor past the end.
TEST(Stages, LeadNowhereWhereSomethingElseIsAsked) {
  for (const Phase phase : {Phase::Interval, Phase::Pause, Phase::Question, Phase::Finished})
    EXPECT_EQ(onward_from(Stage::Trial, phase), Onward::Nowhere);
  EXPECT_EQ(onward_from(Stage::Thanks, Phase::Finished), Onward::Nowhere);
  EXPECT_EQ(onward_from(Stage::End, Phase::Finished), Onward::Nowhere);
}

// It lasts as long whatever was answered: nothing that the examinee does ends it.
TEST(Stages, TakeNothingDuringFeedback) {
  for (const Phase phase : {Phase::Ready, Phase::Finished}) {
    EXPECT_EQ(onward_from(Stage::Feedback, phase), Onward::Nowhere);
    for (const ReplyKind kind :
         {ReplyKind::Continue, ReplyKind::Finish, ReplyKind::Answer, ReplyKind::Early, ReplyKind::Strategy})
      EXPECT_FALSE(takes(Stage::Feedback, phase, kind));
  }
}

TEST(Stages, TakeAnAnswerToAQuestionOnly) {
  for (const Stage stage : kStages)
    for (const Phase phase : kPhases) {
      EXPECT_EQ(takes(stage, phase, ReplyKind::Answer), stage == Stage::Trial && phase == Phase::Question);
      EXPECT_EQ(takes(stage, phase, ReplyKind::Finish), stage == Stage::Trial && phase == Phase::Interval);
      EXPECT_EQ(takes(stage, phase, ReplyKind::Strategy), stage == Stage::Thanks);
    }
}

TEST(Stages, HaveANameThatThePageKnows) {
  EXPECT_EQ(shown_name(Stage::Welcome, Phase::Ready), "welcome");
  EXPECT_EQ(shown_name(Stage::Trial, Phase::Ready), "ready");
  EXPECT_EQ(shown_name(Stage::Trial, Phase::Question), "question");
  EXPECT_EQ(shown_name(Stage::Fault, Phase::Ready), "fault");
  EXPECT_EQ(shown_name(Stage::Feedback, Phase::Ready), "feedback");
}

TEST(Stages, LetTheProbeMoveInPracticeAndIntervalsOnly) {
  for (const Stage stage : kStages)
    for (const Phase phase : kPhases)
      EXPECT_EQ(is_pressing(stage, phase),
                stage == Stage::Gesture || (stage == Stage::Trial && phase == Phase::Interval));
}

}  // namespace
}  // namespace palpate::app
