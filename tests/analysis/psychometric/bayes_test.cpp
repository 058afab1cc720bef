#include "analysis/psychometric/bayes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/analysis/psychometric/support.hpp"

using namespace palpate::analysis;

TEST(LogBetaBinomial, AgreesWithR) {
  // R 4.2, eta = 1/3, so that v = 8: lbeta(3 + .6 * 8, 7 + .4 * 8) - lbeta(.6 * 8, .4 * 8)
  EXPECT_NEAR(log_beta_binomial(3, 10, 0.6, 1.0 / 3), -7.36765372434, 1e-10);
  EXPECT_NEAR(log_beta_binomial(3, 10, 0.6, 0), 3 * std::log(0.6) + 7 * std::log(0.4), 1e-12);
}

TEST(LogBetaBinomial, ProbabilitiesAddUpToOne) {
  for (const double eta : {0.0, 1e-5, 2e-4, 0.01, 0.3, 0.9}) {
    double sum = 0;
    for (int k = 0; k <= 20; ++k)
      sum += std::exp(std::lgamma(21) - std::lgamma(k + 1) - std::lgamma(21 - k) +
                      log_beta_binomial(k, 20, 0.7, eta));
    EXPECT_NEAR(sum, 1, 1e-6) << eta;  // near eta = 1e-4, differences of lgamma of 1e8 keep 8 digits
  }
}

TEST(BayesianPsychometric, ModeIsTheMaximumLikelihoodOfPsignifitsExample) {
  // The example data of psignifit 4. All priors are even there but those of lapse and eta, which both are 0
  // at the mode: threshold and width are those of maximum likelihood. R 4.2: optim of the binomial likelihood
  // of .5 + .5 * pnorm(2 * qnorm(.95) * (x - m)/w): 0.004647817, 0.004659072. psignifit's own figures (test
  // test_psignifit_fixed_fit of python-psignifit: 0.00464485, 0.00468384, lapse 1.1e-7, eta 1.2e-4) are
  // 0.0011 less likely, their search being coarser: within 0.1 and 0.6 percent.
  const std::vector<Block> blocks =
      blocks_from({.001, .0015, .002, .0025, .003, .0035, .004, .0045, .005, .006, .007, .008, .01},
                  {45, 50, 44, 44, 52, 53, 62, 64, 76, 79, 88, 90, 90}, 90);
  const BayesianFit fit = bayesian_psychometric(blocks, Shape::Gaussian, 0.5, 0.95);
  EXPECT_NEAR(fit.threshold.mode / 0.004647817, 1, 1e-4);
  EXPECT_NEAR(fit.width.mode / 0.004659072, 1, 1e-4);
  EXPECT_NEAR(fit.lapse.mode, 0, 1e-6);
  EXPECT_NEAR(fit.eta.mode, 0, 1e-3);
  EXPECT_NEAR(fit.threshold.mode / 0.0046448472, 1, 0.001);
  EXPECT_NEAR(fit.width.mode / 0.0046838374, 1, 0.006);
  EXPECT_LT(fit.threshold.interval.lower, fit.threshold.mean);
  EXPECT_GT(fit.threshold.interval.upper, fit.threshold.mean);
}

TEST(BayesianPsychometric, AgreesWithAPlainSum) {
  // Python 3.11, numpy and scipy.special.betaln: the posterior of [Schuett2016] at 121 x 111 x 61 x 60 points
  // (threshold -1 to 7, width 1 to 12, lapse 0 to 0.5, eta 0.0075 to 0.9), summed. Its steps are 0.07, 0.1,
  // 0.008 and 0.015: it agrees to a part of these, eta least, whose mode is at its end.
  const auto blocks = blocks_from({1, 2, 3, 4, 5}, {5, 6, 8, 10, 10}, 10);
  const BayesianFit fit = bayesian_psychometric(blocks, Shape::Logistic, 0.5, 0.95);
  EXPECT_NEAR(fit.threshold.mean, 2.46541, 0.01);
  EXPECT_NEAR(fit.threshold.interval.lower, 1.09758, 0.02);
  EXPECT_NEAR(fit.threshold.interval.upper, 3.59043, 0.02);
  EXPECT_NEAR(fit.width.mean, 4.01711, 0.02);
  EXPECT_NEAR(fit.width.interval.lower, 1.54056, 0.03);
  EXPECT_NEAR(fit.width.interval.upper, 8.47951, 0.05);
  EXPECT_NEAR(fit.lapse.mean, 0.04007, 0.002);
  EXPECT_NEAR(fit.lapse.interval.upper, 0.14100, 0.004);
  EXPECT_NEAR(fit.eta.mean, 0.0845, 0.01);
}

TEST(BayesianPsychometric, AnswersSeparableData) {
  const BayesianFit fit =
      bayesian_psychometric(blocks_from({1, 2, 3, 4}, {5, 5, 10, 10}, 10), Shape::Weibull, 0.5, 0.95);
  EXPECT_TRUE(std::isfinite(fit.width.mean));
  EXPECT_GT(fit.threshold.interval.lower, 1.0);
  EXPECT_LT(fit.threshold.interval.upper, 4.0);
  EXPECT_FALSE(fit.guess);
}

TEST(BayesianPsychometric, KnowsAGuessRateOnlyFromTheData) {
  // 5 of 60 at levels far below threshold: 0.083; its standard error 0.036
  const auto blocks = blocks_from({1, 2, 5, 6, 9, 10}, {2, 3, 10, 20, 28, 29}, 30);
  const BayesianFit fit = bayesian_psychometric(blocks, Shape::Logistic, std::nullopt, 0.95);
  ASSERT_TRUE(fit.guess);
  EXPECT_NEAR(fit.guess->mean, 0.083, 0.036);
  EXPECT_LT(fit.guess->interval.upper, 0.25);
}
