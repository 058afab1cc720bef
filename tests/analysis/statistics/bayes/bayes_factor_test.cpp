#include "analysis/statistics/bayes/bayes_factor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace palpate::analysis;

TEST(BayesFactor, AgreesWithNumericalIntegration) {
  // R 4.2: bf <- function(k, n, c, lo, hi, a = 1, b = 1) integrate(function(p) dbinom(k, n, p)*dbeta(p, a,
  // b), lo,
  //   hi, rel.tol = 1e-12)$value/diff(pbeta(c(lo, hi), a, b))/dbinom(k, n, c)
  const auto factor = [](long k, long n, double chance, Side side, BetaPrior prior) {
    return bayes_factor(k, n, chance, side, prior).bayes_factor;
  };
  EXPECT_NEAR(factor(41, 60, 0.5, Side::Greater, {}), 18.4451638266743, 1e-8);     // bf(41, 60, .5, .5, 1)
  EXPECT_NEAR(factor(41, 60, 0.5, Side::TwoSided, {}), 9.24312021644479, 1e-8);    // bf(41, 60, .5, 0, 1)
  EXPECT_NEAR(factor(31, 60, 0.5, Side::Greater, {}), 0.198474612550378, 1e-10);   // bf(31, 60, .5, .5, 1)
  EXPECT_NEAR(factor(10, 30, 1.0 / 3, Side::Less, {}), 0.294876050275186, 1e-10);  // bf(10, 30, 1/3, 0, 1/3)
  // bf(10, 30, 1/3, 1/3, 1, 2, 3)
  EXPECT_NEAR(factor(10, 30, 1.0 / 3, Side::Greater, {2, 3}), 0.321604874106517, 1e-10);
}

TEST(BayesFactor, OfTheUniformPriorIsOneOverTheNumberOfOutcomes) {
  // Jeffreys 1961, section 5.1: every number of correct answers is equally likely then.
  for (const long k : {0L, 3L, 9L}) {
    double seen = std::pow(0.5, 9);  // P(k of 9 | chance)
    for (long i = 1; i <= k; ++i) seen *= static_cast<double>(9 - k + i) / static_cast<double>(i);
    EXPECT_NEAR(bayes_factor(k, 9, 0.5, Side::TwoSided, {}).bayes_factor, 0.1 / seen, 1e-11);
  }
}

TEST(BayesFactor, HasThePosteriorOfATruncatedBeta) {
  // R 4.2: q <- function(u, k, n, c) {t <- pbeta(c, 1 + k, 1 + n - k); qbeta(t + u*(1 - t), 1 + k, 1 + n -
  // k)}; q(c(.025, .5, .975), 31, 60, .5)
  const BayesFactor result = bayes_factor(31, 60, 0.5, Side::Greater, {});
  EXPECT_NEAR(result.interval.lower, 0.502469304041937, 1e-9);
  EXPECT_NEAR(result.posterior_median, 0.549549658857004, 1e-9);
  EXPECT_NEAR(result.interval.upper, 0.651128553110296, 1e-9);
}

TEST(BayesFactor, StaysANumberWhereAnswersAreMany) {
  const BayesFactor result = bayes_factor(70'000, 100'000, 0.5, Side::Greater, {});
  EXPECT_TRUE(std::isfinite(result.log_bayes_factor));
  EXPECT_GT(result.log_bayes_factor, 8000);  // 1e5 times the divergence, 0.0823, less the price of the prior
  EXPECT_LT(bayes_factor(500, 1000, 0.9, Side::Greater, {}).log_bayes_factor, 0);
}

TEST(BayesFactor, IsPutIntoKassAndRafterysWords) {
  EXPECT_EQ(evidence_in_words(std::log(2.9)), "evidence not worth more than a bare mention against chance");
  EXPECT_EQ(evidence_in_words(std::log(18.4)), "positive evidence against chance");
  EXPECT_EQ(evidence_in_words(-std::log(21)), "strong evidence for chance");
  EXPECT_EQ(evidence_in_words(1e6), "very strong evidence against chance");
}

TEST(BayesFactor, RefusesPriorsThatAreNone) {
  EXPECT_THROW(bayes_factor(3, 5, 0.5, Side::Greater, {0, 1}), std::invalid_argument);
  EXPECT_THROW(bayes_factor(3, 5, 0.5, Side::Greater, {1, INFINITY}), std::invalid_argument);
}
