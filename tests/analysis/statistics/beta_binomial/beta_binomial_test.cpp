#include "analysis/statistics/beta_binomial/beta_binomial.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

using namespace palpate::analysis;
using testing::HasSubstr;

namespace {

std::vector<ExamineeCount> counts_of(const std::vector<long>& correct, const std::vector<long>& trials) {
  std::vector<ExamineeCount> counts;
  for (std::size_t i = 0; i < correct.size(); ++i) {
    counts.push_back({.correct = correct[i], .trials = trials[trials.size() == 1 ? 0 : i]});
  }
  return counts;
}

// Hunter's experiments, data sets 1 and 2 of Brockhoff 2003: triangle tests, 12 each.
std::vector<ExamineeCount> hunter_1() {
  return counts_of({0, 2, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 5, 5, 5, 6, 6, 6, 7, 7, 7, 8, 9, 9}, {12});
}
std::vector<ExamineeCount> hunter_2() {
  return counts_of({2, 2, 3, 4, 5, 5, 5, 5, 6, 6, 6, 7, 7, 7, 7, 7, 7, 8, 8, 8, 9, 11, 12}, {12});
}
// The example of sensR's betabin().
std::vector<ExamineeCount> example_of_sensr() {
  return counts_of({3, 2, 6, 8, 3, 4, 6, 0, 9, 9, 0, 2, 1, 2, 8, 9, 5, 7},
                   {10, 9, 8, 9, 8, 6, 9, 10, 10, 10, 9, 9, 10, 10, 10, 10, 9, 10});
}

std::string refusal_of(const std::vector<ExamineeCount>& counts, double chance = 0.5) {
  try {
    beta_binomial(counts, {.chance = chance});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  ADD_FAILURE() << "it was not refused";
  return "";
}

// P(X = x) for every x.
std::vector<double> probabilities(long trials, double chance, double mean, double gamma) {
  std::vector<double> all;
  for (long x = 0; x <= trials; ++x) {
    const double n = static_cast<double>(trials), k = static_cast<double>(x);
    const double ways = std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1);
    all.push_back(std::exp(ways + beta_binomial_log(x, trials, chance, mean, gamma)));
  }
  return all;
}

}  // namespace

// All figures "by R" below are of R 4.2: the likelihood by Gauss-Jacobi quadrature where corrected, r <-
// statmod::gauss.quad.prob(12, "beta", alpha = a, beta = b); lchoose(n, x) + log(sum(r$weights * (c + (1
// - c) * r$nodes)^x * ((1 - c) * (1 - r$nodes))^(n - x))), else lchoose(n, x) + lbeta(a + x, b + n - x) -
// lbeta(a, b), with a = mu (1 - gamma)/gamma, b = (1 - mu)(1 - gamma)/gamma; optim(method = "L-BFGS-B", factr
// = 100), optimHess(ndeps = 1e-4), profiles by optimize() and uniroot(). They are good to some 1e-6.

TEST(BetaBinomial, AgreesWithBrockhoffAndSensr) {
  const BetaBinomial fit = beta_binomial(hunter_1(), {.chance = 1.0 / 3});
  EXPECT_NEAR(fit.mean.estimate, 0.1175015, 2e-7);            // sensR's tests/betabin.R, after Brockhoff 2003
  EXPECT_NEAR(fit.gamma.estimate, 0.2146566, 2e-7);           // likewise
  EXPECT_NEAR(*fit.mean.standard_error, 0.0503883578, 1e-6);  // by R, as the rest
  EXPECT_NEAR(*fit.gamma.standard_error, 0.157800034, 1e-5);
  EXPECT_NEAR(fit.log_likelihood, -53.3124165733, 1e-9);
  EXPECT_NEAR(fit.binomial_log_likelihood, -54.8279010381, 1e-9);
  EXPECT_NEAR(fit.mean.interval.lower, 0.031739823, 1e-6);
  EXPECT_NEAR(fit.mean.interval.upper, 0.229636598, 1e-6);
  EXPECT_EQ(fit.gamma.interval.lower, 0);  // 0 is not rejected
  EXPECT_NEAR(fit.gamma.interval.upper, 0.627044354, 1e-6);
  EXPECT_NEAR(fit.overdispersion.g_squared, 3.03096892969, 1e-8);
  EXPECT_NEAR(fit.overdispersion.p, 0.0408446102227, 1e-9);  // pchisq(G2, 1, lower = FALSE)/2
  EXPECT_NEAR(fit.against_chance.g_squared, 9.7077119593, 1e-8);
  EXPECT_NEAR(fit.against_chance.p, 0.0077982496084, 1e-9);  // pchisq(G2, 2, lower = FALSE)
  EXPECT_NEAR(fit.proportion.estimate, 1.0 / 3 + 2.0 / 3 * 0.1175015, 2e-7);
}

TEST(BetaBinomial, AgreesWithROnHuntersSecondExperiment) {
  const BetaBinomial fit = beta_binomial(hunter_2(), {.chance = 1.0 / 3});
  EXPECT_NEAR(fit.mean.estimate, 0.300076277, 1e-6);
  EXPECT_NEAR(fit.gamma.estimate, 0.244069293, 1e-6);
  EXPECT_NEAR(fit.gamma.interval.lower, 0.061487681, 1e-6);
  EXPECT_NEAR(fit.gamma.interval.upper, 0.512200418, 1e-6);
  EXPECT_NEAR(fit.log_likelihood, -52.8263052959, 1e-9);
  const BetaBinomial plain = beta_binomial(hunter_2(), {.chance = 1.0 / 3, .corrected = false});
  EXPECT_NEAR(plain.mean.estimate, 0.534094529, 1e-6);
  EXPECT_NEAR(plain.gamma.estimate, 0.0909440349, 1e-6);
  EXPECT_NEAR(*plain.mean.standard_error, 0.042480277, 1e-6);
  EXPECT_NEAR(*plain.gamma.standard_error, 0.0475811154, 1e-6);
  EXPECT_NEAR(plain.log_likelihood, -53.2017458777, 1e-9);
  EXPECT_NEAR(plain.against_chance.g_squared, 18.1214960964, 1e-7);
  EXPECT_NEAR(plain.against_chance.p, 1.03624261857e-05, 1e-11);  // pnorm(-sqrt(G2))
}

TEST(BetaBinomial, AgreesWithROnTheExampleOfSensr) {
  const BetaBinomial fit = beta_binomial(example_of_sensr(), {});
  EXPECT_NEAR(fit.mean.estimate, 0.176051102, 1e-6);
  EXPECT_NEAR(fit.gamma.estimate, 0.504272268, 1e-6);
  EXPECT_NEAR(*fit.mean.standard_error, 0.0827417104, 1e-6);
  EXPECT_NEAR(*fit.gamma.standard_error, 0.1667548611, 1e-5);
  EXPECT_NEAR(fit.log_likelihood, -55.298699082, 1e-9);
  const BetaBinomial plain = beta_binomial(example_of_sensr(), {.corrected = false});
  EXPECT_NEAR(plain.mean.interval.lower, 0.351922889, 1e-6);
  EXPECT_NEAR(plain.mean.interval.upper, 0.633430447, 1e-6);
  EXPECT_NEAR(plain.gamma.interval.lower, 0.167852479, 1e-6);
  EXPECT_NEAR(plain.gamma.interval.upper, 0.498611235, 1e-6);
  EXPECT_NEAR(plain.against_chance.p, 0.534076602623, 1e-7);  // below chance
  // By R: p <- sum(x)/sum(n); (sum((x - n*p)^2)/(p*(1 - p)) - sum(n))/sqrt(2*sum(n*(n - 1)))
  EXPECT_NEAR(plain.tarone.z, 9.65443911419, 1e-10);
  EXPECT_NEAR(plain.tarone.p, 2.35364057879e-22, 1e-32);
}

TEST(BetaBinomial, EndsOnTheEdgesOfWhatCanBe) {
  // Hunter's first data scored against chance 1/2: fewer correct than by guessing. sensR's tests expect mu =
  // 0.
  const BetaBinomial below = beta_binomial(hunter_1(), {});
  EXPECT_EQ(below.mean.estimate, 0);
  EXPECT_TRUE(std::isnan(below.gamma.estimate));
  EXPECT_EQ(below.proportion.estimate, 0.5);
  EXPECT_FALSE(below.mean.standard_error);
  EXPECT_EQ(below.against_chance.p, 1);
  EXPECT_EQ(below.overdispersion.p, 1);
  // Everybody alike: the binomial, whose proportion has the standard error sqrt(p (1 - p)/n).
  const BetaBinomial alike = beta_binomial(counts_of({6, 7, 6, 7}, {10}), {.corrected = false});
  EXPECT_EQ(alike.gamma.estimate, 0);
  EXPECT_NEAR(alike.mean.estimate, 26.0 / 40, 1e-7);
  EXPECT_NEAR(*alike.mean.standard_error, std::sqrt(0.65 * 0.35 / 40), 1e-6);
  EXPECT_EQ(alike.overdispersion.p, 1);
  EXPECT_LT(alike.tarone.z, 0);
  // All or nothing: as good as one answer from each.
  const BetaBinomial all = beta_binomial(counts_of({10, 0, 10, 0, 10}, {10}), {.corrected = false});
  EXPECT_EQ(all.gamma.estimate, 1);
  EXPECT_NEAR(all.mean.estimate, 0.6, 1e-6);
}

RC_GTEST_PROP(BetaBinomialProbability, SumsToOneAndHasItsMean, ()) {
  const long trials = *rc::gen::inRange(1L, 60L);
  const auto fraction = [] { return *rc::gen::inRange(0, 101) / 100.0; };
  const double chance = fraction() * 0.9, mean = fraction(), gamma = fraction();
  const std::vector<double> p = probabilities(trials, chance, mean, gamma);
  double sum = 0, first = 0;
  for (std::size_t x = 0; x < p.size(); ++x) sum += p[x], first += p[x] * static_cast<double>(x);
  RC_ASSERT(std::abs(sum - 1) < 1e-11);
  RC_ASSERT(std::abs(first / static_cast<double>(trials) - (chance + (1 - chance) * mean)) < 1e-11);
}

TEST(BetaBinomialProbability, IsTheBinomialWithoutSpread) {
  for (const double chance : {0.0, 0.5}) {
    const double p = chance + (1 - chance) * 0.3;
    EXPECT_NEAR(beta_binomial_log(7, 12, chance, 0.3, 0), 7 * std::log(p) + 5 * std::log(1 - p), 1e-12);
  }
}

TEST(BetaBinomialProbability, BearsLongSeries) {
  // R 4.2: lbeta(2 + 3000, 6 + 2000) - lbeta(2, 6); mu = 1/4, gamma = 1/9
  EXPECT_NEAR(beta_binomial_log(3000, 5000, 0, 0.25, 1.0 / 9), -3370.46387896362, 1e-8);
  EXPECT_TRUE(std::isfinite(beta_binomial_log(3000, 5000, 0.01, 0.25, 1.0 / 9)));
}

// Guessers are found above chance no oftener than promised, although gamma vanishes under the hypothesis, and
// overdispersed no oftener either: 5 % and 3 Monte-Carlo standard errors of 400 studies, 3.3 %.
TEST(BetaBinomial, LetsGuessersBe) {
  std::mt19937_64 random(11);
  std::binomial_distribution<long> guesses(12, 0.5);
  int above = 0, above_plain = 0, spread = 0;
  constexpr int kStudies = 400;
  for (int study = 0; study < kStudies; ++study) {
    std::vector<long> correct(20);
    for (long& one : correct) one = guesses(random);
    const auto counts = counts_of(correct, {12});
    above += beta_binomial(counts, {}).against_chance.p <= 0.05;
    const BetaBinomial plain = beta_binomial(counts, {.corrected = false});
    above_plain += plain.against_chance.p <= 0.05;
    spread += plain.overdispersion.p <= 0.05;
  }
  EXPECT_LT(above, kStudies * 0.083);
  EXPECT_LT(above_plain, kStudies * 0.083);
  EXPECT_LT(spread, kStudies * 0.083);
  EXPECT_GT(above_plain, kStudies * 0.017);  // and the plain test does not sleep
}

TEST(BetaBinomial, RefusesWhatItCannotAnswer) {
  EXPECT_THAT(refusal_of({{7, 10}}), HasSubstr("at least 2 are needed"));
  EXPECT_THAT(refusal_of({{1, 1}, {0, 1}}), HasSubstr("one trial for each examinee"));
  EXPECT_THAT(refusal_of({{10, 10}, {8, 8}}), HasSubstr("all 18 answers are correct"));
  EXPECT_THAT(refusal_of({{11, 10}, {8, 8}}), HasSubstr("11"));
  EXPECT_THAT(refusal_of({{1, 10}, {8, 8}}, 1.0), HasSubstr("chance"));
}
