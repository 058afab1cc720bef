#include "analysis/psychometric/compare.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/analysis/psychometric/support.hpp"

using namespace palpate::analysis;
using testing::HasSubstr;

namespace {

const std::vector<PsychometricCondition> kTwo{{"a", blocks_from({0, 1, 2, 3, 4}, {5, 14, 24, 40, 45}, 50)},
                                              {"b", blocks_from({0, 1, 2, 3, 4}, {2, 8, 20, 30, 44}, 50)}};

}  // namespace

// R 4.2: d <- data.frame(x = rep(0:4, 2), c = rep(c("a", "b"), each = 5), k = c(5, 14, 24, 40, 45, 2, 8, 20,
// 30, 44)); f <- glm(cbind(k, 50 - k) ~ x * c, binomial, d); deviance(glm(cbind(k, 50 - k) ~ x, binomial, d))
// - deviance(f); the same with ~ x + c
TEST(PsychometricCompare, OfFunctionAndSlopeIsR_anovaOfGlm) {
  const PsychometricComparison function = compare_psychometric(kTwo, kNoGuess, Same::Function);
  EXPECT_NEAR(function.chi_squared, 7.457575203527, 1e-8);
  EXPECT_EQ(function.degrees_of_freedom, 2);
  EXPECT_NEAR(function.p, 0.0240218922, 1e-7);  // R: pchisq(7.457575203527, 2, lower.tail = FALSE)
  const PsychometricComparison slope = compare_psychometric(kTwo, kNoGuess, Same::Slope);
  EXPECT_NEAR(slope.chi_squared, 0.104832172917, 1e-8);
  EXPECT_EQ(slope.degrees_of_freedom, 1);
  EXPECT_NEAR(slope.same.beta[0], slope.same.beta[1], 1e-12);
}

TEST(PsychometricCompare, OfThresholdAgreesWithR_optim) {
  // R 4.2: optim (BFGS, reltol 1e-15) of the likelihood with one threshold and a slope for each, and of that
  // with two of each: 2 x the difference, and the threshold
  const PsychometricComparison found = compare_psychometric(kTwo, kNoGuess, Same::Threshold);
  EXPECT_NEAR(found.chi_squared, 7.22167131518, 1e-7);
  EXPECT_NEAR(found.same.alpha[0], 2.21347690934, 1e-5);
  EXPECT_NEAR(found.same.alpha[1], 2.21347690934, 1e-5);
}

TEST(PsychometricCompare, ConditionsShareTheLapseRate) {
  const std::vector<PsychometricCondition> two{{"a", psignifit_blocks()}, {"b", psignifit_blocks()}};
  const PsychometricComparison found = compare_psychometric(two, {}, Same::Function);
  EXPECT_NEAR(found.chi_squared, 0, 1e-8);
  EXPECT_NEAR(found.separate.lapse, fit_of(psignifit_blocks(), {}).lapse, 1e-5);
  EXPECT_NEAR(found.separate.log_likelihood, 2 * fit_of(psignifit_blocks(), {}).log_likelihood, 1e-8);
}

TEST(PsychometricCompare, RejectsATrueHypothesisAsOftenAsItSays) {
  std::mt19937_64 random(5);
  constexpr int kStudies = 400;
  int rejected = 0;
  for (int i = 0; i < kStudies; ++i) {
    const auto draw = [&](double beta) {
      return simulated({1, 2, 3, 4, 5, 6}, 60, Shape::Logistic, 0, 0.0, 3.3, beta, random);
    };
    const std::vector<PsychometricCondition> two{{"a", draw(1.0)}, {"b", draw(1.6)}};
    rejected += compare_psychometric(two, kNoGuess, Same::Threshold).p < 0.05;
  }
  // Monte-Carlo standard error sqrt(.05 x .95/400) = 0.011; four of them
  EXPECT_NEAR(rejected / double(kStudies), 0.05, 0.044);
}

TEST(PsychometricCompare, TellsWhichConditionAllowsNoFunction) {
  std::vector<PsychometricCondition> two = kTwo;
  two[1].blocks = blocks_from({0, 1, 2, 3, 4}, {0, 0, 50, 50, 50}, 50);
  EXPECT_THAT(*compare_psychometric(two, kNoGuess, Same::Slope).why_not,
              HasSubstr("condition b: its answers are separable"));
  two[1].blocks = blocks_from({0, 1, 2}, {30, 20, 10}, 50);
  EXPECT_THAT(*compare_psychometric(two, kNoGuess, Same::Slope).why_not,
              HasSubstr("condition b: its answers do not rise"));
  two[1].blocks = blocks_from({1}, {30}, 50);
  EXPECT_THAT(*compare_psychometric(two, kNoGuess, Same::Slope).why_not,
              HasSubstr("condition b: 1 distinct level"));
  two.pop_back();
  EXPECT_THROW(compare_psychometric(two, kNoGuess, Same::Slope), std::invalid_argument);
}
