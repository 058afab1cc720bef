#include "analysis/mixed/population.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include "tests/analysis/mixed/support/data_sets.hpp"

using namespace palpate::analysis;

TEST(GlmmAnalysis, AgreesWithRWhereNobodyDiffers) {
  // R 4.2: m <- glm(cbind(correct, 10 - correct) ~ level, binomial("logit")); MASS::dose.p(m, p = c(.5,
  // .75)); deviance(glm(. ~ 1)) - deviance(m). The slope test's null model has a variance of 0 as well.
  const GlmmAnalysis result = glmm_analysis(four_alike(), {.link = Link::Logit});
  EXPECT_NEAR(result.pse.estimate, 2.5, 1e-7);
  EXPECT_NEAR(result.pse.standard_error, 0.149827915034, 1e-7);
  EXPECT_NEAR(result.jnd.estimate, 3.35412056503 - 2.5, 1e-7);
  EXPECT_NEAR(result.jnd.standard_error, 0.854120565 * 0.202240171808 / 1.286249662686, 1e-7);
  EXPECT_NEAR(result.slope_test.chi_squared, 57.9194748109, 1e-7);
  EXPECT_NEAR(result.slope.z, 1.286249662686 / 0.202240171808, 1e-6);
}

TEST(GlmmAnalysis, AgreesWithLme4sComparisonOfModels) {
  // anova(glmer(cbind(ones, 10 - ones) ~ 1 + (1 + level|examinee), ...), glmer(. ~ level + ..., ...))$Chisq
  const GlmmAnalysis result =
      glmm_analysis(eight_examinees(), {.link = Link::Logit, .random = RandomEffects::Slope});
  EXPECT_NEAR(result.slope_test.chi_squared, 15.54633347, 1e-6);
  EXPECT_NEAR(result.slope_test.p, 8.05e-05, 5e-8);  // pchisq(15.54633347, 1, lower.tail = FALSE)
}

TEST(GlmmAnalysis, IntervalsEndWhereFiellerSays) {
  const GlmmAnalysis result = glmm_analysis(eight_examinees(), {.link = Link::Probit, .nodes = 9}, 0.9);
  const Eigen::Matrix2d& v = result.fit.covariance;
  for (const double x : {result.pse.interval.lower, result.pse.interval.upper}) {
    const double error = std::sqrt(v(0, 0) + 2 * x * v(0, 1) + x * x * v(1, 1));
    // qnorm(.95): at its ends the predictor is so many standard errors from 0
    EXPECT_NEAR(std::abs(result.fit.fixed[0] + result.fit.fixed[1] * x) / error, 1.64485362695147, 1e-10);
  }
  EXPECT_LT(result.pse.interval.lower, result.pse.estimate);
  EXPECT_GT(result.pse.interval.upper, result.pse.estimate);
  EXPECT_NEAR(result.jnd.interval.lower * result.slope.interval.upper, 0.674489750196082, 1e-12);
  EXPECT_NEAR(result.jnd.interval.upper * result.slope.interval.lower, 0.674489750196082, 1e-12);
}

TEST(GlmmAnalysis, LeavesIntervalsOpenWhereTheSlopeMayBeZero) {
  const GlmmAnalysis result =
      glmm_analysis({{"a", 1, 4, 10}, {"a", 2, 6, 10}, {"b", 1, 5, 10}, {"b", 2, 5, 10}}, {});
  EXPECT_TRUE(result.fit.convergence.converged);
  EXPECT_LT(result.slope.interval.lower, 0);
  EXPECT_TRUE(std::isinf(result.pse.interval.lower) && std::isinf(result.pse.interval.upper));
  EXPECT_TRUE(std::isinf(result.jnd.interval.upper));
  EXPECT_GT(result.jnd.interval.lower, 0);
}

// Intervals of 95 % hold the truth in 95 % of studies, but for the Monte-Carlo error of 200 (3 standard
// errors: 4.6 %) and Wald's optimism with 20 examinees (some 2 %).
TEST(GlmmAnalysis, RecoversWhatWasSimulated) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  int held_pse = 0, held_jnd = 0;
  double sum_spread = 0;
  constexpr int kStudies = 200;
  for (int study = 0; study < kStudies; ++study) {
    std::vector<LevelAnswers> answers;
    for (int examinee = 0; examinee < 20; ++examinee) {
      const double shift = 0.5 * normal(random);
      for (int level = 0; level < 7; ++level) {
        const double p = std::erfc(-(shift + 0.8 * (level - 3)) / std::sqrt(2.0)) / 2;
        long ones = 0;
        for (int trial = 0; trial < 10; ++trial) ones += uniform(random) < p;
        answers.push_back({std::to_string(examinee), static_cast<double>(level), ones, 10});
      }
    }
    const GlmmAnalysis result = glmm_analysis(answers, {.nodes = 7});
    ASSERT_TRUE(result.fit.convergence.converged) << result.fit.convergence.reason;
    held_pse += result.pse.interval.lower <= 3 && 3 <= result.pse.interval.upper;
    const double jnd = 0.674489750196082 / 0.8;
    held_jnd += result.jnd.interval.lower <= jnd && jnd <= result.jnd.interval.upper;
    sum_spread += result.fit.spread.intercept;
  }
  EXPECT_NEAR(held_pse / double(kStudies), 0.94, 0.056);
  EXPECT_NEAR(held_jnd / double(kStudies), 0.94, 0.056);
  // Maximum likelihood is low by a factor of about 1 - 3/(4 * 20); the standard error of the mean is 0.006.
  EXPECT_NEAR(sum_spread / kStudies, 0.48, 0.025);
}

// The same answers at levels in another unit, counted from another origin.
TEST(GlmmAnalysis, DoesNotHangOnUnitOrOriginOfTheLevel) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> power(-12, 12), shift(-1000, 1000);
  for (const GlmmOptions& options :
       {GlmmOptions{.nodes = 9}, GlmmOptions{.random = RandomEffects::Slope, .nodes = 5}}) {
    const GlmmAnalysis here = glmm_analysis(eight_examinees(), options);
    for (int i = 0; i < 5; ++i) {
      const double unit = std::pow(10.0, power(random)), origin = unit * shift(random);
      SCOPED_TRACE(testing::Message() << "unit " << unit << ", origin " << origin);
      std::vector<LevelAnswers> moved = eight_examinees();
      for (LevelAnswers& row : moved) row.level = origin + unit * row.level;
      const GlmmAnalysis there = glmm_analysis(moved, options);
      const auto of_level = [&](double level) { return (origin + unit * level) / unit; };
      EXPECT_NEAR(there.fit.log_likelihood, here.fit.log_likelihood, 1e-9);
      EXPECT_NEAR(there.slope_test.chi_squared, here.slope_test.chi_squared, 1e-8);
      EXPECT_NEAR(there.slope.p, here.slope.p, 1e-8);
      EXPECT_NEAR(there.slope.estimate * unit, here.slope.estimate, 1e-7);
      EXPECT_NEAR(there.slope.standard_error * unit, here.slope.standard_error, 1e-6);
      EXPECT_NEAR(there.pse.estimate / unit, of_level(here.pse.estimate), 1e-7);
      EXPECT_NEAR(there.pse.standard_error / unit, here.pse.standard_error, 1e-6);
      EXPECT_NEAR(there.pse.interval.lower / unit, of_level(here.pse.interval.lower), 1e-6);
      EXPECT_NEAR(there.pse.interval.upper / unit, of_level(here.pse.interval.upper), 1e-6);
      EXPECT_NEAR(there.jnd.interval.upper / unit, here.jnd.interval.upper, 1e-6);
    }
  }
}
