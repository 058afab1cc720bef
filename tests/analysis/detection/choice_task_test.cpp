#include "analysis/detection/choice_task.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>

#include "analysis/detection/dprime.hpp"

using namespace palpate::analysis;
using testing::HasSubstr;

namespace {

constexpr auto kDifferencing = Strategy::Differencing;
constexpr auto kIndependent = Strategy::IndependentObservations;

ChoiceTask among(long alternatives) {
  return choice_task("m-AFC", alternatives, {});
}
ChoiceTask task(std::string_view name, std::optional<Strategy> strategy = {}) {
  return choice_task(name, {}, strategy);
}

std::vector<ChoiceTask> all_tasks() {
  return {task("2IFC"),
          task("2AFC"),
          among(3),
          among(8),
          task("triangle"),
          task("oddity", kDifferencing),
          task("oddity", kIndependent),
          task("ABX", kDifferencing),
          task("ABX", kIndependent)};
}

std::string refusal(std::string_view name, std::optional<long> alternatives,
                    std::optional<Strategy> strategy) {
  try {
    choice_task(name, alternatives, strategy);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST(ProportionCorrect, OfManyAlternativesAgreesWithHackerAndRatcliff) {
  // Hacker & Ratcliff 1979 (Macmillan & Creelman 2005, table A5.7), two decimals: d' at 50, 75 and 90 %.
  const std::vector<std::pair<long, std::vector<double>>> table = {
      {3, {0.56, 1.43, 2.23}}, {4, {0.84, 1.68, 2.45}}, {8, {1.34, 2.14, 2.87}}};
  for (const auto& [m, expected] : table) {
    EXPECT_NEAR(d_prime_at(among(m), 0.50), expected[0], 0.005) << m;
    EXPECT_NEAR(d_prime_at(among(m), 0.75), expected[1], 0.005) << m;
    EXPECT_NEAR(d_prime_at(among(m), 0.90), expected[2], 0.005) << m;
  }
  // Palamedes, example of PAL_SDT_MAFC_DPtoPC([0 1 2 3 ..], 25), four decimals.
  EXPECT_NEAR(proportion_correct(among(25), 1), 0.1997, 5e-5);
  EXPECT_NEAR(proportion_correct(among(25), 3), 0.8263, 5e-5);
}

TEST(ProportionCorrect, OfManyAlternativesAgreesWithR) {
  // R 4.2: integrate(function(x) dnorm(x - d)*pnorm(x)^(m - 1), -Inf, Inf, rel.tol = 1e-12)$value
  EXPECT_NEAR(proportion_correct(among(3), 1), 0.63370204577808, 1e-11);
  EXPECT_NEAR(proportion_correct(among(4), 0.5), 0.393317842815077, 1e-11);
  EXPECT_NEAR(proportion_correct(among(8), 2), 0.710998282277809, 1e-11);
}

TEST(ProportionCorrect, OfTheTriangleAgreesWithEnnisAndR) {
  // Ennis 1993, table for the triangular method: 0.42 at d' = 1, 0.60 at d' = 2. The rest by R 4.2:
  // integrate(function(x) 2*(pnorm(-x*sqrt(3) + d*sqrt(2/3)) + pnorm(-x*sqrt(3) - d*sqrt(2/3)))*dnorm(x),
  //           0, Inf, rel.tol = 1e-12)$value
  EXPECT_NEAR(proportion_correct(task("triangle"), 0.5), 0.355834649628561, 1e-10);
  EXPECT_NEAR(proportion_correct(task("triangle"), 1), 0.418046674714639, 1e-10);
  EXPECT_NEAR(proportion_correct(task("triangle"), 2), 0.604806932772189, 1e-10);
  EXPECT_NEAR(proportion_correct(task("triangle"), 3), 0.781427598596484, 1e-10);
}

TEST(ProportionCorrect, OfOddityAgreesWithPalamedes) {
  // Palamedes, example of PAL_SDT_3AFCoddity_IndMod_PCtoDP([.5 .6 .7 .8 .9]), after Versfeld et al. 1996.
  const double d_primes[] = {1.2451, 1.6686, 2.1012, 2.6060, 3.3245};
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(d_prime_at(task("oddity", kIndependent), 0.5 + 0.1 * i), d_primes[i], 1e-4);
  }
}

TEST(ProportionCorrect, OfAbxAgreesWithPalamedes) {
  // Palamedes, examples of PAL_SDT_2AFCmatchSample_{DiffMod,IndMod}_DPtoPC([0 1 2 3 4 5]), four decimals.
  const double differencing[] = {0.5, 0.5825, 0.7468, 0.8765, 0.9467, 0.9792};
  const double independent[] = {0.5, 0.5997, 0.7877, 0.9185, 0.9750, 0.9936};
  for (int d = 0; d < 6; ++d) {
    EXPECT_NEAR(proportion_correct(task("ABX", kDifferencing), d), differencing[d], 5.1e-5) << d;
    EXPECT_NEAR(proportion_correct(task("ABX", kIndependent), d), independent[d], 5.1e-5) << d;
  }
}

TEST(ProportionCorrect, OfOddityIsWhatTheRulesGiveWhenActedOut) {
  std::mt19937_64 random(20261123);
  std::normal_distribution<double> noise;
  constexpr int kTrials = 200'000;  // standard error 0.0011
  int differs_most = 0, likeliest = 0;
  for (int i = 0; i < kTrials; ++i) {
    const double x[] = {noise(random) + 0.75, noise(random) - 0.75, noise(random) - 0.75};
    const double sum = x[0] + x[1] + x[2];
    const auto first_wins = [&](double weight) {
      const auto away = [&](int j) { return std::abs(weight * x[j] - sum); };
      return away(0) > away(1) && away(0) > away(2);
    };
    differs_most += first_wins(3);  // farthest from the mean of the three
    likeliest += first_wins(2);     // |x - half the sum of all|: the likelihood ratio of being the odd one
  }
  EXPECT_NEAR(proportion_correct(task("oddity", kDifferencing), 1.5), differs_most / double{kTrials}, 0.005);
  EXPECT_NEAR(proportion_correct(task("oddity", kIndependent), 1.5), likeliest / double{kTrials}, 0.005);
}

TEST(ProportionCorrect, StartsAtChanceAndEndsAtCertainty) {
  for (const ChoiceTask& one : all_tasks()) {
    EXPECT_NEAR(proportion_correct(one, 0), chance_of(one), 1e-12) << name_of(one);
    EXPECT_NEAR(proportion_correct(one, 25), 1, 1e-12) << name_of(one);
    EXPECT_TRUE(std::isinf(d_prime_at(one, 1))) << name_of(one);
    if (!knows_direction(one)) EXPECT_EQ(d_prime_at(one, 0.2), 0) << name_of(one);
  }
}

RC_GTEST_PROP(ProportionCorrect, GivesBackTheDPrimeItWasMadeFrom, ()) {
  const double d = *rc::gen::inRange(1, 60) / 10.0;
  const auto tasks = all_tasks();
  const ChoiceTask one = tasks[*rc::gen::inRange<std::size_t>(0, tasks.size())];
  const double p = proportion_correct(one, d);
  // Where the curve is flat, digits of p are digits of d' no more.
  RC_ASSERT(std::abs(d_prime_at(one, p) - d) < 1e-9 + 1e-12 / slope_at(one, d));
  RC_ASSERT(proportion_correct(one, d + 0.1) > p);
}

TEST(ChoiceTask, SaysWhatItNeeds) {
  EXPECT_THAT(refusal("m-AFC", {}, {}), HasSubstr("m-AFC needs alternatives"));
  EXPECT_THAT(refusal("m-AFC", 1, {}), HasSubstr("with 1 alternatives; accepted: 2 to 1000"));
  EXPECT_THAT(refusal("2IFC", 3, {}), HasSubstr("takes no alternatives"));
  EXPECT_THAT(refusal("ABX", {}, {}), HasSubstr("needs a strategy"));
  EXPECT_THAT(refusal("triangle", {}, kDifferencing), HasSubstr("takes no strategy"));
  EXPECT_THAT(refusal("duo-trio", {}, {}), HasSubstr("task is 'duo-trio'; accepted: 2IFC"));
}

TEST(DPrime, OfTheTriangleAgreesWithR) {
  // R 4.2, with tri(d) the integral above: uniroot(function(d) tri(d) - .5, c(0, 8), tol = 1e-13)$root, its
  // ends likewise at binom.test(30, 60)$conf.int; h <- 1e-4; sqrt(.25/60)/((tri(u + h) - tri(u - h))/(2*h))
  const DPrime d = dprime(task("triangle"), 30, 60, DPrimeCorrection::HalfTrial);
  EXPECT_NEAR(d.d_prime, 1.4662627800557, 1e-9);
  EXPECT_NEAR(d.standard_error, 0.338557974835247, 1e-7);
  EXPECT_NEAR(d.interval.lower, 0.624754305498562, 1e-8);
  EXPECT_NEAR(d.interval.upper, 2.13898296522653, 1e-8);
}

TEST(DPrime, IsZeroBelowChanceWhereNoDirectionIsKnown) {
  const DPrime d = dprime(task("triangle"), 18, 60, DPrimeCorrection::HalfTrial);  // 30 %
  EXPECT_EQ(d.d_prime, 0);
  EXPECT_TRUE(std::isinf(d.standard_error));
  EXPECT_EQ(d.interval.lower, 0);
  EXPECT_GT(d.interval.upper, 0.5);
  EXPECT_TRUE(std::isnan(dprime(task("triangle"), 2, 60, DPrimeCorrection::HalfTrial).interval.upper));
  EXPECT_LT(dprime(among(3), 18, 60, DPrimeCorrection::HalfTrial).d_prime, 0);  // the weakest was chosen
}
