// QUEST+ against runs that were published, and against what it computes, computed directly.
#include "trials/procedures/questplus/questplus.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numeric>

#include "tests/trials/support/adaptive.hpp"
#include "trials/adaptive/entropy_choice.hpp"
#include "trials/adaptive/psychometric.hpp"
#include "trials/plan/random.hpp"

namespace palpate::trials::test {
namespace {

using testing::HasSubstr;

/// "[-40, -39, .., 0]"
std::string whole_numbers(int from, int to) {
  std::string list;
  for (int i = from; i <= to; ++i) list += fmt::format("{}{}", list.empty() ? "[" : ", ", i);
  return list + "]";
}

std::string weibull(const std::string& slope, const std::string& lapse) {
  return fmt::format(
      "kind = \"questplus\"\nfunction = \"weibull_db\"\nlevels = {0}\n"
      "parameters = {{ threshold = {0}, slope = {1}, guess = 0.5, lapse = {2} }}\n",
      whole_numbers(-40, 0), slope, lapse);
}

/// A run of Watson 2017: levels, answers and what is most likely at the end, as
/// questplus/tests/test_qp.py of github.com/hoechenberger/questplus (commit 15e63bf1) has them.
struct WatsonRun {
  std::string name, keys;
  std::vector<int> levels;
  std::string_view answers;
  std::map<std::string_view, double> mode;
};

const std::vector<WatsonRun>& watson_runs() {
  static const std::vector<WatsonRun> runs{
      {"Example1Threshold",
       weibull("3.5", "0.02"),
       {-18, -22, -25, -28, -30, -22, -13, -15, -16, -18, -19, -20, -21, -22, -23, -19,
        -20, -20, -18, -18, -19, -17, -17, -18, -18, -18, -19, -19, -19, -19, -19, -19},
       "11110011111111011011011111111111",
       {{"threshold", -20}}},
      {"ImplementationThresholdAndSlope",
       weibull("[2, 3, 4, 5]", "0.02"),
       {-18, -22, -12, -13, -15, -16, -17, -18, -19, -21, -24, -25, -26, -27, -21, -22,
        -23, -20, -20, -20, -21, -19, -19, -20, -20, -20, -19, -19, -19, -19, -19, -20,
        -20, -20, -20, -20, -21, -21, -20, -20, -20, -19, -18, -18, -19, -19, -19, -18,
        -18, -17, -18, -18, -18, -17, -17, -17, -17, -17, -17, -17, -18, -18, -18, -18},
       "1011111111111011011101111011111111111011001111010111011111111111",
       {{"threshold", -20}, {"slope", 3}}},
      {"Example2ThresholdSlopeAndLapse",
       weibull("[2, 3, 4, 5]", "[0, 0.01, 0.02, 0.03, 0.04]"),
       {-18, -22, -25, -28, -30, -21, -12, -14, -15, -16, -18, -19, -20, -22, -23, -18, -19, -16, -17,
        -17, -18, -18, -18, -19, -19, -17, -17, -18, -18, -18, -18, -19, -19, -20, -18, -18, -18, -18,
        -18, -19, -19, -19, -19, -20, -18, -18, -18, -18, -18, -18, -18, -18, -18, -19, -19, -19, -20,
        -18, -18, -18, -18, -19, -19, -19, -18, -18, -18, -18, -19, -19, -19, -19, -19, -19, -19, -19,
        -20, -21, -19, -19, -19, -19, -19, -19, -19, -18, -19, -19, -16, -16, -16, -16, -16, -16, 0,
        0,   -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -21, -21, -19, -19,
        -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19},
       "1111001111111101011111110111111110111111111011101111111101111110"
       "1111111111111010111101101111111011111111111111101110100111101111",
       {{"threshold", -20}, {"slope", 5}, {"lapse", 0.04}}},
  };
  return runs;
}

const EntropyDesign& grid_of(const LoadedProcedure& loaded) {
  return static_cast<const EntropyDesign&>(*loaded.design);
}

/// Of Bayes' rule, answer by answer and without what the program has prepared [bit].
double entropy_after(const LoadedProcedure& loaded, std::vector<double> posterior, double level,
                     bool correct) {
  const EntropyDesign& design = grid_of(loaded);
  const auto at = std::ranges::find(design.levels, level) - design.levels.begin();
  double sum = 0.0, bits = 0.0;
  for (std::size_t i = 0; i < posterior.size(); ++i) {
    const double p = design.share_correct[at * posterior.size() + i];
    sum += posterior[i] *= correct ? p : 1.0 - p;
  }
  for (const double share : posterior)
    if (share > 0.0) bits -= share / sum * std::log2(share / sum);
  return bits;
}

double chance_of_correct(const LoadedProcedure& loaded, const std::vector<double>& posterior, double level) {
  const EntropyDesign& design = grid_of(loaded);
  const auto at = std::ranges::find(design.levels, level) - design.levels.begin();
  return std::inner_product(posterior.begin(), posterior.end(),
                            design.share_correct.begin() + at * std::ssize(posterior), 0.0);
}

class Watson : public testing::TestWithParam<WatsonRun> {};

const std::string kSmallGrid =
    "kind = \"questplus\"\nfunction = \"logistic\"\nlevels = [0, 1, 2, 3, 4, 5]\n"
    "parameters = { threshold = [1, 2, 3, 4], slope = [0.5, 2], guess = 0.5, lapse = [0.01, 0.05] }\n";

}  // namespace

TEST_P(Watson, LevelsAndModeAreThosePublished) {
  const WatsonRun& published = GetParam();
  const LoadedProcedure loaded = procedure_of(published.keys);
  ASSERT_EQ(published.levels.size(), published.answers.size());
  const PlayedRun played = play(loaded, published.answers);
  EXPECT_THAT(played.levels, testing::ElementsAreArray(published.levels.begin(), published.levels.end()));
  for (const ParameterBelief& parameter : loaded.procedure->belief(*loaded.design, played.run).parameters)
    if (const auto mode = published.mode.find(parameter.name); mode != published.mode.end()) {
      EXPECT_EQ(parameter.mode, mode->second) << parameter.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Published, Watson, testing::ValuesIn(watson_runs()),
                         [](const auto& run) { return run.param.name; });

// At every trial, the level that is chosen leaves least, computed from the posteriors after each answer.
TEST(QuestPlus, ExpectedAndActualEntropiesAreThoseOfBayesRule) {
  const LoadedProcedure loaded = procedure_of(kSmallGrid);
  const AdaptiveProcedure& procedure = *loaded.procedure;
  AdaptiveRun run = begin_adaptive(procedure, *loaded.design);
  std::vector<double> posterior = grid_of(loaded).prior;
  for (const char answer : std::string_view("1101110011101")) {
    const double level = next_level(procedure, *loaded.design, run).value();
    const auto expected = [&](double at) {
      const double p = chance_of_correct(loaded, posterior, at);
      return p * entropy_after(loaded, posterior, at, true) +
             (1.0 - p) * entropy_after(loaded, posterior, at, false);
    };
    const double promised = procedure.belief(*loaded.design, run).expected_entropy.value();
    EXPECT_NEAR(promised, expected(level), 1e-12);
    for (const double other : grid_of(loaded).levels) EXPECT_LE(promised, expected(other) + 1e-12);
    tell_adaptive(procedure, *loaded.design, run, {.level = level, .correct = answer == '1'});
    EXPECT_NEAR(procedure.belief(*loaded.design, run).entropy,
                entropy_after(loaded, posterior, level, answer == '1'), 1e-12);
    posterior.assign(run.memory.end() - std::ssize(posterior), run.memory.end());
  }
}

TEST(QuestPlus, MeanAndSpreadAreThoseOfThePosterior) {
  const LoadedProcedure loaded = procedure_of(kSmallGrid);
  const AdaptiveRun run = play(loaded, "1101").run;
  const std::vector<double> posterior(run.memory.end() - 16, run.memory.end());
  double mean = 0.0, square = 0.0;  // of the slope, the second of four parameters: runs over pairs of lapses
  for (std::size_t i = 0; i < 16; ++i) {
    const double slope = i / 2 % 2 == 0 ? 0.5 : 2.0;
    mean += posterior[i] * slope;
    square += posterior[i] * slope * slope;
  }
  const Belief belief = loaded.procedure->belief(*loaded.design, run);
  EXPECT_EQ(belief.parameters[1].name, "slope");
  EXPECT_NEAR(belief.parameters[1].mean, mean, 1e-12);
  EXPECT_NEAR(belief.parameters[1].sd, std::sqrt(square - mean * mean), 1e-7);
}

TEST(QuestPlus, OfLevelsThatTellAsMuchTheLowestIsTaken) {
  // Mirror images about 0: the levels -2 and 2, and -1 and 1, tell as much.
  const LoadedProcedure loaded = procedure_of(
      "kind = \"questplus\"\nfunction = \"normal\"\nlevels = [-2, -1, 1, 2]\n"
      "parameters = { threshold = [-1, 1], slope = 1, guess = 0, lapse = 0 }");
  EXPECT_EQ(next_level(*loaded.procedure, *loaded.design, begin_adaptive(*loaded.procedure, *loaded.design)),
            -1.0);
}

TEST(QuestPlus, ThePriorIsWeighted) {
  const LoadedProcedure loaded = procedure_of(kSmallGrid + "prior = { threshold = [0, 3, 1, 0] }");
  const Belief belief =
      loaded.procedure->belief(*loaded.design, begin_adaptive(*loaded.procedure, *loaded.design));
  EXPECT_NEAR(belief.parameters[0].mean, 0.75 * 2 + 0.25 * 3, 1e-12);
  EXPECT_NEAR(belief.entropy, -0.75 * std::log2(0.75) + 0.25 * 2 + 2.0,
              1e-12);  // and one bit each of slope and lapse
}

TEST(QuestPlus, QuantitiesStandInDecibelsOfTheirRatio) {
  const LoadedProcedure in_pascals = procedure_of(
      "kind = \"questplus\"\nfunction = \"weibull_db\"\nlevels = [\"1 MPa\", \"10 MPa\"]\n"
      "parameters = { threshold = [\"1 MPa\", \"2 MPa\"], slope = 2, guess = 0.5, lapse = 0 }");
  // 1 - (1 - guess) exp(-(level / threshold)^slope)
  EXPECT_NEAR(grid_of(in_pascals).share_correct[1], 1.0 - 0.5 * std::exp(-0.25), 1e-12);
  EXPECT_NEAR(grid_of(in_pascals).share_correct[3], 1.0 - 0.5 * std::exp(-25.0), 1e-12);
}

TEST(QuestPlus, WhatHasNoMassOrNoMeaningIsRefused) {
  const auto said = [](const std::string& parameters, const std::string& more = "") {
    return refusal_of_procedure(
        "kind = \"questplus\"\nfunction = \"logistic\"\nlevels = [0, 1]\nparameters = { " + parameters +
        " }\n" + more);
  };
  const std::string sound = "threshold = [0, 1], slope = 1, guess = 0.5, lapse = 0";
  EXPECT_EQ(said(sound), "");
  EXPECT_EQ(said(sound, "prior = { threshold = [0, 0] }"),
            "p.toml:6: procedure.prior.threshold: has no weight above 0; accepted: at least one");
  EXPECT_THAT(said(sound, "prior = { threshold = [1] }"), HasSubstr("has 1 weights for 2 values"));
  EXPECT_THAT(said(sound, "prior = { threshold = [1, -1] }"),
              HasSubstr("holds -1, accepted: weights of 0 or above"));
  EXPECT_THAT(said("threshold = [1, 0], slope = 1, guess = 0.5, lapse = 0"), HasSubstr("found 0 after 1"));
  EXPECT_THAT(said("threshold = 0, slope = 0, guess = 0.5, lapse = 0"),
              HasSubstr("accepted: slopes above 0"));
  EXPECT_THAT(said("threshold = 0, slope = 1, guess = 0.5, lapse = 0.5"), HasSubstr("together below 1"));
  EXPECT_THAT(said("threshold = \"1 MPa\", slope = 1, guess = 0.5, lapse = 0"),
              HasSubstr("accepted: a number without a unit, as the levels before it"));
  EXPECT_THAT(said("threshold = " + whole_numbers(1, 2000) + ", slope = " + whole_numbers(1, 1000) +
                   ", guess = 0.5, lapse = 0"),
              HasSubstr("4000000 pairs of a level and a combination of parameters, accepted: up to 2000000"));
}

TEST(QuestPlus, AnAnswerThatNoParameterAllowsIsRefused) {
  const LoadedProcedure loaded = procedure_of(
      "kind = \"questplus\"\nfunction = \"normal\"\nlevels = [100]\n"
      "parameters = { threshold = [0, 1], slope = 10, guess = 0, lapse = 0 }");
  EXPECT_THROW(play(loaded, "0"), std::invalid_argument);
}

RC_GTEST_PROP(QuestPlus, TheOrderOfAnswersAtTheSameLevelsDoesNotMatter, ()) {
  const LoadedProcedure loaded = procedure_of(kSmallGrid);
  auto answers = *rc::gen::container<std::vector<AdaptiveAnswer>>(rc::gen::apply(
      [](int level, bool correct) {
        return AdaptiveAnswer{static_cast<double>(level), correct};
      },
      rc::gen::inRange(0, 6), rc::gen::arbitrary<bool>()));
  const Belief one =
      loaded.procedure->belief(*loaded.design, replay_adaptive(*loaded.procedure, *loaded.design, answers));
  std::ranges::reverse(answers);
  const Belief other =
      loaded.procedure->belief(*loaded.design, replay_adaptive(*loaded.procedure, *loaded.design, answers));
  RC_ASSERT(std::abs(one.entropy - other.entropy) < 1e-9);
  for (std::size_t i = 0; i < one.parameters.size(); ++i)
    RC_ASSERT(std::abs(one.parameters[i].mean - other.parameters[i].mean) < 1e-9);
}

// Threshold -20 dB, slope 3.5, lapses 2 in 100. Estimates of these 60 runs of 100 trials have an sd of 0.64
// dB, so their mean has a standard error of 0.08 dB; it is held within 0.3 dB, a third of the grid's grain.
TEST(QuestPlus, FindsAKnownObserver) {
  const LoadedProcedure loaded = procedure_of(weibull("[2, 3, 4, 5]", "0.02"));
  Generator random = make_generator(22, "observer of QUEST+");
  double sum = 0.0;
  constexpr int kRuns = 60;
  for (int i = 0; i < kRuns; ++i) {
    const PlayedRun played = play_observer(loaded, 100, [&](double level) {
      return random.uniform() < share_correct(PsychometricFunction::WeibullDb, level,
                                              {.threshold = -20, .slope = 3.5, .guess = 0.5, .lapse = 0.02});
    });
    sum += loaded.procedure->belief(*loaded.design, played.run).parameters[0].mean;
  }
  EXPECT_NEAR(sum / kRuns, -20.0, 0.3);
}

// Three unknown parameters, 41 levels, 820 combinations: between two questions. The bound is what an examinee
// does not notice, and far above what is measured, for machines that are shared.
TEST(QuestPlus, ANextLevelIsThereAtOnce) {
  const LoadedProcedure loaded = procedure_of(weibull("[2, 3, 4, 5]", "[0, 0.01, 0.02, 0.03, 0.04]"));
  Generator random = make_generator(23, "observer of QUEST+");
  AdaptiveRun run = begin_adaptive(*loaded.procedure, *loaded.design);
  std::vector<double> seconds;
  for (int trial = 0; trial < 200; ++trial) {
    const auto start = std::chrono::steady_clock::now();
    const double level = next_level(*loaded.procedure, *loaded.design, run).value();
    tell_adaptive(*loaded.procedure, *loaded.design, run,
                  {.level = level, .correct = random.uniform() < 0.8});
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::ranges::sort(seconds);
  RecordProperty("p99_us", static_cast<int>(1e6 * seconds[197]));
  RecordProperty("median_us", static_cast<int>(1e6 * seconds[100]));
  EXPECT_LT(seconds[197], 0.05);
}

}  // namespace palpate::trials::test
