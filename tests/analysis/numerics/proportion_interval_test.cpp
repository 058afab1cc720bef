#include "analysis/numerics/proportion_interval.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace palpate::analysis;

namespace {

constexpr double kRelative = 1e-9;

double coverage(const std::vector<Interval>& intervals, double p) {
  const long n = std::ssize(intervals) - 1;
  double total = 0.0;
  for (long k = 0; k <= n; ++k) {
    const Interval& interval = intervals[k];
    if (p < interval.lower || p > interval.upper) continue;
    double probability = 1.0;  // of k correct answers: the binomial coefficient, factor by factor
    for (long i = 1; i <= k; ++i) probability *= static_cast<double>(n - k + i) / static_cast<double>(i);
    total += probability * std::pow(p, static_cast<double>(k)) * std::pow(1 - p, static_cast<double>(n - k));
  }
  return total;
}

}  // namespace

TEST(ClopperPearson, AgreesWithR) {
  // R 4.2: binom.test(x, n)$conf.int
  const Interval some = clopper_pearson(41, 60), none = clopper_pearson(0, 10), all = clopper_pearson(10, 10);
  EXPECT_NEAR(some.lower, 0.550440312235947, kRelative);
  EXPECT_NEAR(some.upper, 0.797424492881028, kRelative);
  EXPECT_EQ(none.lower, 0.0);
  EXPECT_NEAR(none.upper, 0.308497107818761, kRelative);
  EXPECT_NEAR(all.lower, 0.691502892181239, kRelative);
  EXPECT_EQ(all.upper, 1.0);
}

TEST(Wilson, AgreesWithR) {
  // R 4.2: prop.test(x, n, correct = FALSE)$conf.int for 41/60, 0/10, 10/10, 1/1
  EXPECT_NEAR(wilson(41, 60).lower, 0.557662329738232, kRelative);
  EXPECT_NEAR(wilson(41, 60).upper, 0.786941324476335, kRelative);
  EXPECT_EQ(wilson(0, 10).lower, 0.0);
  EXPECT_NEAR(wilson(0, 10).upper, 0.277532799862889, kRelative);
  EXPECT_NEAR(wilson(10, 10).lower, 0.722467200137111, kRelative);
  EXPECT_NEAR(wilson(1, 1).lower, 0.206549314377238, kRelative);
  EXPECT_EQ(wilson(1, 1).upper, 1.0);
}

TEST(ClopperPearson, CoversEveryProportionWithAtLeastItsLevel) {
  // By adding up the probabilities of all outcomes whose interval holds p; nothing is drawn at random.
  for (const long n : {1L, 2L, 5L, 12L, 30L, 60L}) {
    for (const double level : {0.90, 0.95, 0.99}) {
      std::vector<Interval> intervals;
      for (long k = 0; k <= n; ++k) intervals.push_back(clopper_pearson(k, n, level));
      for (int i = 1; i < 200; ++i) {
        EXPECT_GE(coverage(intervals, i / 200.0), level - 1e-12) << "n = " << n << ", p = " << i / 200.0;
      }
    }
  }
}

TEST(ClopperPearsonBound, CoversWithAtLeastItsLevelOnItsSide) {
  std::vector<Interval> lower, upper;
  for (long k = 0; k <= 25; ++k) {
    lower.push_back(clopper_pearson_bound(k, 25, Side::Greater));
    upper.push_back(clopper_pearson_bound(k, 25, Side::Less));
  }
  for (int i = 1; i < 100; ++i) {
    EXPECT_GE(coverage(lower, i / 100.0), 0.95 - 1e-12);
    EXPECT_GE(coverage(upper, i / 100.0), 0.95 - 1e-12);
  }
}

TEST(Wilson, CoversOnTheAverageWithAboutItsLevel) {
  std::vector<Interval> intervals;
  for (long k = 0; k <= 60; ++k) intervals.push_back(wilson(k, 60));
  double total = 0.0;
  for (int i = 1; i < 500; ++i) total += coverage(intervals, i / 500.0);
  EXPECT_NEAR(total / 499, 0.95, 0.01);  // Agresti & Coull 1998, fig. 2: within a percent from n = 5 on
}

TEST(Jeffreys, AgreesWithStatsmodelsAndR) {
  // statsmodels 0.13: proportion_confint(41, 60, method="jeffreys"); R 4.2: qbeta(c(.025, .975), 41.5, 19.5)
  EXPECT_NEAR(jeffreys(41, 60).lower, 0.5591577353271098, kRelative);
  EXPECT_NEAR(jeffreys(41, 60).upper, 0.7902983053789724, kRelative);
  EXPECT_EQ(jeffreys(0, 10).lower, 0.0);
  EXPECT_NEAR(jeffreys(0, 10).upper, 0.217196267509211, kRelative);  // R 4.2: qbeta(.975, .5, 10.5)
  EXPECT_EQ(jeffreys(10, 10).upper, 1.0);
}

TEST(Jeffreys, CoversOnTheAverageWithAboutItsLevel) {
  std::vector<Interval> intervals;
  for (long k = 0; k <= 60; ++k) intervals.push_back(jeffreys(k, 60));
  double total = 0.0;
  for (int i = 1; i < 500; ++i) total += coverage(intervals, i / 500.0);
  EXPECT_NEAR(total / 499, 0.95, 0.01);  // Brown, Cai & DasGupta 2001, fig. 5
}
