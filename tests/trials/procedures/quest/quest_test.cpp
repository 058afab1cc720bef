#include "trials/procedures/quest/quest.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/trials/support/adaptive.hpp"
#include "trials/plan/random.hpp"

namespace palpate::trials::test {
namespace {

using testing::HasSubstr;

// PsychoPy's QuestHandler, psychopy/tests/test_data/test_StairHandlers.py of github.com/psychopy/psychopy
// (commit 0271d00a): two correct and two wrong answers in turn. The first level is its start value, not
// QUEST's.
const std::string kPsychoPyQuest =
    "kind = \"quest\"\nguess_level = 50\nguess_sd = 50\ntarget = 0.82\nbeta = 3.5\ngamma = 0.5\ndelta = 0.01\n"
    "grain = 0.01\nrange = 100\n";
constexpr std::string_view kTwoAndTwo = "1100110011";
const std::vector<double> kPsychoPyLevels{50,
                                          45.139710407074872,
                                          37.291086503930742,
                                          58.297413127139947,
                                          80.182967131096547,
                                          75.295251409003527,
                                          71.57627192423783,
                                          79.881680484036906,
                                          90.712313302815517,
                                          88.265808957695796};
// It looks the offset up by a straight line between points of the grid, h = 0.01 apart, where it is solved
// here: off by about h^2 / 8 times beta ln 10 = 1e-4, in each answer.
constexpr double kLookUp = 5e-4;

std::vector<AdaptiveAnswer> psychopy_answers() {
  std::vector<AdaptiveAnswer> answers;
  for (std::size_t i = 0; i < kTwoAndTwo.size(); ++i)
    answers.push_back({kPsychoPyLevels[i], kTwoAndTwo[i] == '1'});
  return answers;
}

/// Watson and Pelli's function, written down a second time: 82 % at the threshold.
double weibull_of_log10(double x, double threshold) {
  constexpr double kBeta = 3.5, kDelta = 0.01, kGamma = 0.5, kTarget = 0.82;
  const auto share = [](double at) {
    return kDelta * kGamma + (1 - kDelta) * (1 - (1 - kGamma) * std::exp(-std::pow(10, kBeta * at)));
  };
  double low = -1.0, high = 1.0;  // where it is at the target, by bisection
  for (int i = 0; i < 60; ++i) (share(0.5 * (low + high)) < kTarget ? low : high) = 0.5 * (low + high);
  return share(x - threshold + low);
}

}  // namespace

TEST(Quest, QuantilesAreThoseOfPsychoPy) {
  const LoadedProcedure loaded = procedure_of(kPsychoPyQuest);
  AdaptiveRun run = begin_adaptive(*loaded.procedure, *loaded.design);
  for (std::size_t i = 0; i < kTwoAndTwo.size(); ++i) {
    if (i > 0) {
      EXPECT_NEAR(next_level(*loaded.procedure, *loaded.design, run).value(), kPsychoPyLevels[i], kLookUp)
          << i;
    }
    tell_adaptive(*loaded.procedure, *loaded.design, run, psychopy_answers()[i]);
  }
  EXPECT_NEAR(next_level(*loaded.procedure, *loaded.design, run).value(), 86.3849031085, kLookUp);
}

TEST(Quest, MeanAndModeAreThoseOfPsychoPy) {
  const auto after = [](const std::string& next) {
    const LoadedProcedure loaded = procedure_of(kPsychoPyQuest + "next = \"" + next + "\"");
    const AdaptiveRun run = replay_adaptive(*loaded.procedure, *loaded.design, psychopy_answers());
    const Belief belief = loaded.procedure->belief(*loaded.design, run);
    EXPECT_NEAR(belief.parameters[0].mean, 86.0772169427, kLookUp);
    EXPECT_NEAR(belief.parameters[0].mode, 80.11, 1e-9);
    return next_level(*loaded.procedure, *loaded.design, run).value();
  };
  EXPECT_NEAR(after("mean"), 86.0772169427, kLookUp);
  EXPECT_NEAR(after("mode"), 80.11, 1e-9);
}

TEST(Quest, ExpectedEntropyIsThatOfBothAnswers) {
  const LoadedProcedure loaded = procedure_of(
      "kind = \"quest\"\nguess_level = -1\nguess_sd = 0.5\ngrain = 0.1\nrange = 2\nnext = \"mode\"");
  const auto entropy = [&](const AdaptiveRun& run) {
    return loaded.procedure->belief(*loaded.design, run).entropy;
  };
  AdaptiveRun run = begin_adaptive(*loaded.procedure, *loaded.design);
  for (const char answer : std::string_view("1101")) {
    const double level = next_level(*loaded.procedure, *loaded.design, run).value();
    double p = 0.0;
    for (int i = 0; i < 21; ++i) p += run.memory[i] * weibull_of_log10(level, -2.0 + 0.1 * i);
    AdaptiveRun right = run, wrong = run;
    tell_adaptive(*loaded.procedure, *loaded.design, right, {level, true});
    tell_adaptive(*loaded.procedure, *loaded.design, wrong, {level, false});
    EXPECT_NEAR(loaded.procedure->belief(*loaded.design, run).expected_entropy.value(),
                p * entropy(right) + (1 - p) * entropy(wrong), 1e-9);
    run = answer == '1' ? right : wrong;
  }
}

TEST(Quest, QuantitiesAreTakenByTheirLogarithm) {
  const std::string keys = "guess_sd = 0.5\nnext = \"mean\"\n";
  const PlayedRun plain = play(procedure_of("kind = \"quest\"\nguess_level = 1\n" + keys), "11010");
  const PlayedRun pascals =
      play(procedure_of("kind = \"quest\"\nguess_level = \"10 MPa\"\n" + keys), "11010");
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(std::log10(pascals.levels[i]), plain.levels[i], 1e-9);
}

TEST(Quest, WhatCannotBeIsRefused) {
  const auto said = [](const std::string& more) {
    return refusal_of_procedure("kind = \"quest\"\nguess_sd = 1\n" + more);
  };
  EXPECT_THAT(said("guess_level = 0\ntarget = 0.5"),
              HasSubstr("procedure.target: found 0.5, accepted: a share above 0.5"));
  EXPECT_THAT(said("guess_level = \"0 MPa\""), HasSubstr("accepted: a quantity above 0"));
  EXPECT_THAT(said("guess_level = 0\ngrain = 1e-9"), HasSubstr("accepted: up to 100000"));
  EXPECT_THAT(said("guess_level = 0\nnext = \"median\""), HasSubstr("quantile, mean, mode"));
  EXPECT_THAT(said("guess_level = 0\nrange = -1"), HasSubstr("procedure.range: found -1"));
}

RC_GTEST_PROP(Quest, LevelsStayOnTheGrid, ()) {
  const LoadedProcedure loaded = procedure_of(
      fmt::format("kind = \"quest\"\nguess_level = -1\nguess_sd = 1\nrange = 2\ngrain = 0.05\nnext = \"{}\"",
                  *rc::gen::element<std::string>("quantile", "mean", "mode")));
  const PlayedRun played = play(loaded, *rc::gen::container<std::string>(rc::gen::element('0', '1')));
  for (const double level : played.levels) RC_ASSERT(level >= -2.0 - 1e-9 && level <= 1e-9);
}

// The threshold is 0.3 off the guess. Estimates of these 100 runs of 60 trials have an sd of 0.042, which is
// what the procedure itself says of them (0.042 in the mean), so their mean has a standard error of 0.004; it
// is held within 0.02.
TEST(Quest, FindsAKnownObserver) {
  const LoadedProcedure loaded = procedure_of("kind = \"quest\"\nguess_level = -1\nguess_sd = 1\n");
  Generator random = make_generator(24, "observer of QUEST");
  double mean = 0.0, sd = 0.0;
  constexpr int kRuns = 100;
  for (int i = 0; i < kRuns; ++i) {
    const PlayedRun played = play_observer(
        loaded, 60, [&](double level) { return random.uniform() < weibull_of_log10(level, -1.3); });
    const ParameterBelief threshold = loaded.procedure->belief(*loaded.design, played.run).parameters[0];
    mean += threshold.mean / kRuns;
    sd += threshold.sd / kRuns;
  }
  EXPECT_NEAR(mean, -1.3, 0.02);
  EXPECT_NEAR(sd, 0.042, 0.01);
}

}  // namespace palpate::trials::test
