#include "trials/procedures/pest/pest.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/trials/support/adaptive.hpp"
#include "trials/plan/random.hpp"

namespace palpate::trials::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// With a target of 3/4 and W = 1, four correct answers at a level lower it and two wrong ones raise it.
const std::string kPestKeys =
    "kind = \"pest\"\nstart = 10\nfirst_step = 2\nmin_step = 0.5\ntarget = 0.75\nwald = 1\n";

/// The level of each stay, however many questions it took.
std::vector<double> stays(const PlayedRun& played) {
  std::vector<double> levels;
  for (const double level : played.levels)
    if (levels.empty() || levels.back() != level) levels.push_back(level);
  return levels;
}

}  // namespace

// Taylor and Creelman's four rules, by hand: 8, 6 (second step: the same), 2 (third: doubled), 4 (turned:
// halved), 6 (second), 8 (third, not doubled since the step before the turn was), 12 (fourth: doubled), 10
// (turned), 11, 10.5; the next step would be 0.25.
TEST(Pest, StepsFollowTheRules) {
  const LoadedProcedure loaded = procedure_of(kPestKeys + "max_step = 4");
  const PlayedRun played = play(loaded, "11111111111100000000111100111100");
  EXPECT_THAT(stays(played), ElementsAre(10, 8, 6, 2, 4, 6, 8, 12, 10, 11, 10.5));
  EXPECT_EQ(trials_of(played.run.reversals), (std::vector{14, 24, 26, 30, 32}));
  EXPECT_FALSE(next_level(*loaded.procedure, *loaded.design, played.run).has_value());
  EXPECT_EQ(loaded.procedure->estimate(*loaded.design, played.run), 10.75);
}

TEST(Pest, AThirdStepIsDoubledWhereTheOneBeforeTheTurnWasNot) {
  const PlayedRun played = play(procedure_of(kPestKeys + "max_step = 4"), "11110000001");
  EXPECT_THAT(stays(played), ElementsAre(10, 8, 9, 10, 12));
}

TEST(Pest, NoStepIsLargerThanTheLargest) {
  const PlayedRun played = play(procedure_of(kPestKeys + "max_step = 3"), "11111111111111111");
  EXPECT_THAT(stays(played), ElementsAre(10, 8, 6, 3, 0));
}

TEST(Pest, TheCountOfALevelBeginsAnew) {
  // Three correct and one wrong are what 3/4 expects, as often as one likes.
  const PlayedRun played = play(procedure_of(kPestKeys + "max_step = 4"), "111011101110");
  EXPECT_THAT(stays(played), ElementsAre(10));
  EXPECT_THAT(stays(play(procedure_of(kPestKeys + "max_step = 4"), "11110111011")), ElementsAre(10, 8));
}

TEST(Pest, BeforeTheEndThereIsNoEstimate) {
  const LoadedProcedure loaded = procedure_of(kPestKeys + "max_step = 4");
  EXPECT_FALSE(loaded.procedure->estimate(*loaded.design, play(loaded, "1111").run).has_value());
}

TEST(Pest, StepsThatDoNotFitAreRefused) {
  EXPECT_THAT(refusal_of_procedure(kPestKeys + "max_step = 1"),
              HasSubstr("procedure.first_step: found 2, accepted: from min_step 0.5 to max_step 1"));
  EXPECT_THAT(refusal_of_procedure("kind = \"pest\"\nstart = 1\nfirst_step = 1\nmin_step = 0\nmax_step = 1"),
              HasSubstr("procedure.min_step: found 0, accepted: steps above 0"));
}

RC_GTEST_PROP(Pest, LevelsStayWithinLimitsAndReplayIsTheSame, ()) {
  const LoadedProcedure loaded = procedure_of(kPestKeys + "max_step = 4\nmin = 5\nmax = 12");
  const auto answers = *rc::gen::container<std::vector<bool>>(rc::gen::arbitrary<bool>());
  std::size_t i = 0;
  const PlayedRun played =
      play_observer(loaded, static_cast<int>(answers.size()), [&](double) { return answers[i++]; });
  std::vector<AdaptiveAnswer> told;
  for (std::size_t j = 0; j < played.levels.size(); ++j) {
    RC_ASSERT(played.levels[j] >= 5.0 && played.levels[j] <= 12.0);
    told.push_back({played.levels[j], answers[j]});
  }
  RC_ASSERT(replay_adaptive(*loaded.procedure, *loaded.design, told) == played.run);
}

// A logistic observer of scale 1 without guesses is right in 3/4 at log 3. Estimates of these 200 runs have
// an sd of 0.41, so their mean has a standard error of 0.03; it is held within 0.1.
TEST(Pest, FindsTheTarget) {
  const LoadedProcedure loaded =
      procedure_of("kind = \"pest\"\nstart = 3\nfirst_step = 1\nmin_step = 0.125\nmax_step = 2");
  Generator random = make_generator(26, "observer of PEST");
  double sum = 0.0;
  for (int i = 0; i < 200; ++i) {
    const PlayedRun played = play_observer(
        loaded, 100000, [&](double level) { return random.uniform() < 1.0 / (1.0 + std::exp(-level)); });
    sum += loaded.procedure->estimate(*loaded.design, played.run).value();
  }
  EXPECT_NEAR(sum / 200, std::log(3.0), 0.1);
}

}  // namespace palpate::trials::test
