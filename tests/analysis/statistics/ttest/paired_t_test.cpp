#include "analysis/statistics/ttest/paired_t.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

using namespace palpate::analysis;

TEST(PairedT, AgreesWithStudentsSleepAndR) {
  // Student 1908, the second drug less the first: t = 4.06. R 4.2: t.test(d)
  const std::vector<double> sleep = {1.2, 2.4, 1.3, 1.3, 0, 1, 1.8, 0.8, 4.6, 1.4};
  const PairedTTest test = paired_t_test(sleep);
  EXPECT_NEAR(test.t, 4.06212768338203656, 1e-12);
  EXPECT_NEAR(test.p.two_sided, 0.00283289019738427, 1e-14);
  EXPECT_NEAR(test.interval.lower, 0.70011423672301754, 1e-12);
  EXPECT_NEAR(test.interval.upper, 2.45988576327698238, 1e-12);
  EXPECT_EQ(test.degrees_of_freedom, 9);
  EXPECT_NEAR(test.cohen_dz, 1.28455756259105, 1e-13);
  // R 4.2: sapply(c(.975, .025), function(a) uniroot(function(x) pt(t, 9, x) - a, c(-10, 20), tol =
  // 1e-13)$root)/ sqrt(10); pt warns of its precision, 1e-9
  EXPECT_NEAR(test.dz_interval.lower, 0.414627756380144, 1e-7);
  EXPECT_NEAR(test.dz_interval.upper, 2.11801651397707, 1e-7);
}

TEST(PairedT, GivesBothSides) {
  const std::vector<double> d = {3, 1, 2, -1, 4, 2, 0, 3, 1, 2};
  const PairedTTest test = paired_t_test(d);
  EXPECT_NEAR(test.p.greater, 0.00288646466904072,
              1e-14);  // R 4.2: t.test(d, alternative = "greater")$p.value
  EXPECT_NEAR(test.p.greater + test.p.less, 1, 1e-15);
  EXPECT_NEAR(test.dz_interval.lower, 0.312098983018349, 1e-7);  // R 4.2: as above
  EXPECT_NEAR(test.dz_interval.upper, 1.92688557355464, 1e-7);
}

TEST(PairedT, TurnsAroundWithTheSignsAndHasNoUnit) {
  const std::vector<double> d = {3, 1, 2, -1, 4, 2, 0, 3, 1, 2};
  std::vector<double> turned;
  for (const double value : d) turned.push_back(-1000 * value);
  const PairedTTest one = paired_t_test(d), other = paired_t_test(turned);
  EXPECT_NEAR(one.t, -other.t, 1e-12);
  EXPECT_NEAR(one.dz_interval.lower, -other.dz_interval.upper, 1e-9);
}

TEST(PairedT, FindsTheIntervalOfStrongAndWeakEffects) {
  for (const double shift : {0.0, 0.01, 3.0, 40.0}) {
    for (const std::size_t n : {std::size_t{2}, std::size_t{5}, std::size_t{400}}) {
      std::vector<double> d;
      for (std::size_t i = 0; i < n; ++i)
        d.push_back(shift + (i % 2 == 0 ? 1.0 : -1.0) * (1 + 0.01 * double(i % 7)));
      const PairedTTest test = paired_t_test(d);
      EXPECT_LT(test.dz_interval.lower, test.cohen_dz) << shift << ' ' << n;
      EXPECT_GT(test.dz_interval.upper, test.cohen_dz) << shift << ' ' << n;
      // the intervals of the mean and of d_z hold 0 together: both end where t is at its critical value
      EXPECT_EQ(test.interval.lower > 0, test.dz_interval.lower > 0) << shift << ' ' << n;
    }
  }
}

TEST(PairedT, GivesNoIntervalForAnEffectBeyondMeasure) {
  const PairedTTest test = paired_t_test(std::vector<double>{1e9, 1e9 + 1, 1e9 + 2});
  EXPECT_NEAR(test.cohen_dz, 1e9, 10);
  EXPECT_TRUE(std::isnan(test.dz_interval.lower) && std::isnan(test.dz_interval.upper));
}

TEST(PairedT, RefusesDifferencesThatSayNothing) {
  EXPECT_THROW(paired_t_test(std::vector<double>{1.0}), std::invalid_argument);
  EXPECT_THROW(paired_t_test(std::vector<double>{1.0, 1.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(paired_t_test(std::vector<double>{1.0, NAN}), std::invalid_argument);
}
