#include "analysis/report/over_examinees.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace palpate::analysis;

namespace {

std::vector<ExamineeCount> unlike_examinees(std::size_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<ExamineeCount> counts;
  for (std::size_t i = 0; i < n; ++i) {
    const double p = i % 2 == 0 ? 0.55 : 0.95;
    const long trials = i % 3 == 0 ? 10 : 20;
    counts.push_back({std::binomial_distribution<long>(trials, p)(random), trials});
  }
  return counts;
}

}  // namespace

// With many examinees the draws' distribution is normal; its standard error is that of a ratio of sums, linearised
// (Cochran 1977, section 6.4). The ends of 9999 draws' central 95 % have a standard error of about 0.03 of it.
TEST(OverExaminees, IsTheRatioEstimatorsIntervalForManyExaminees) {
  const std::vector<ExamineeCount> counts = unlike_examinees(400, 1);
  double correct = 0, trials = 0, squares = 0;
  for (const ExamineeCount& count : counts) {
    correct += static_cast<double>(count.correct);
    trials += static_cast<double>(count.trials);
  }
  const double proportion = correct / trials;
  for (const ExamineeCount& count : counts)
    squares +=
        std::pow(static_cast<double>(count.correct) - proportion * static_cast<double>(count.trials), 2);
  const double error = std::sqrt(squares) / trials;
  const Interval interval = *interval_over_examinees(counts, 0.95);
  EXPECT_NEAR(interval.lower, proportion - 1.959964 * error, 0.15 * error);
  EXPECT_NEAR(interval.upper, proportion + 1.959964 * error, 0.15 * error);
  // Examinees differ, so that answers taken for independent would promise too much.
  EXPECT_GT(interval.upper - interval.lower, 2.2 * 1.96 * std::sqrt(proportion * (1 - proportion) / trials));
}

TEST(OverExaminees, CannotBeToldFromOneOrFromEqualOnes) {
  EXPECT_FALSE(interval_over_examinees(std::vector<ExamineeCount>{{3, 4}}, 0.95));
  EXPECT_FALSE(interval_over_examinees(std::vector<ExamineeCount>{{3, 4}, {6, 8}, {0, 0}}, 0.95));
  EXPECT_TRUE(interval_over_examinees(std::vector<ExamineeCount>{{3, 4}, {2, 4}}, 0.95));
}
