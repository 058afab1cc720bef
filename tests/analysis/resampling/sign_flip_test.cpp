#include "analysis/resampling/sign_flip.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "analysis/statistics/examinee_level/examinee_level.hpp"

using namespace palpate::analysis;

namespace {

// Darwin's maize, Fisher 1935, section 21: the example of the first permutation test, in eighths of an inch.
const std::vector<double> kDarwin{49, -67, 8, 16, 6, 23, 28, 41, 14, 29, 56, 24, 75, 60, -48};

PValues by_definition(const std::vector<double>& d) {
  const double total = std::accumulate(d.begin(), d.end(), 0.0);
  double greater = 0, less = 0, extreme = 0;
  const std::size_t patterns = std::size_t{1} << d.size();
  for (std::size_t mask = 0; mask < patterns; ++mask) {
    double sum = 0;
    for (std::size_t i = 0; i < d.size(); ++i) sum += (mask >> i & 1) ? -d[i] : d[i];
    greater += sum >= total - 1e-9;
    less += sum <= total + 1e-9;
    extreme += std::abs(sum) >= std::abs(total) - 1e-9;
  }
  const double n = static_cast<double>(patterns);
  return {greater / n, less / n, extreme / n};
}

}  // namespace

TEST(SignFlip, ReproducesFisherOnDarwinsMaize) {
  // Fisher 1935: 863 of 32768 sums are as great or greater: 2.634 %, and 5.267 % on both sides
  const SignFlipTest test = sign_flip_test(kDarwin);
  EXPECT_TRUE(test.exact);
  EXPECT_EQ(test.p.greater, 863.0 / 32768);
  EXPECT_EQ(test.p.two_sided, 1726.0 / 32768);
  EXPECT_NEAR(test.mean, 20.9333333333333, 1e-12);
}

TEST(SignFlip, IntervalHoldsTheShiftsThatAreNotRejected) {
  const SignFlipTest test = sign_flip_test(kDarwin);
  const auto p_at = [](double shift) {
    std::vector<double> shifted = kDarwin;
    for (double& d : shifted) d -= shift;
    return sign_flip_test(shifted).p;
  };
  EXPECT_GT(p_at(test.interval.lower + 1e-6).greater, 0.025);
  EXPECT_LE(p_at(test.interval.lower - 1e-6).greater, 0.025);
  EXPECT_GT(p_at(test.interval.upper - 1e-6).less, 0.025);
  EXPECT_LE(p_at(test.interval.upper + 1e-6).less, 0.025);
}

TEST(SignFlip, IntervalIsOpenWhereTooFewDifferencesCanSayNothing) {
  const std::vector<double> five{1, 2, 3, 4, 5};  // the least p value is 1/32 > 0.025
  EXPECT_TRUE(std::isinf(sign_flip_test(five).interval.lower));
  const std::vector<double> six{1, 2, 3, 4, 5, 6};
  EXPECT_EQ(sign_flip_test(six).interval.lower, 1.0);  // 1/64 <= 0.025 < 2/64: the least of all subset means
}

TEST(SignFlip, EqualsTheDefinition) {
  EXPECT_TRUE(rc::check([] {
    const auto whole =
        *rc::gen::container<std::vector<int>>(*rc::gen::inRange(1, 11), rc::gen::inRange(-4, 5));
    const double unit = *rc::gen::element(1.0, 0.25, 0.1, 1.0 / 3, 0.377123);
    std::vector<double> d;
    for (const int value : whole) d.push_back(value * unit);
    const PValues expected = by_definition(d), found = sign_flip_test(d).p;
    RC_ASSERT(std::abs(found.greater - expected.greater) < 1e-12);
    RC_ASSERT(std::abs(found.less - expected.less) < 1e-12);
    RC_ASSERT(std::abs(found.two_sided - expected.two_sided) < 1e-12);
  }));
}

TEST(SignFlip, StaysExactOnAGridWhateverTheNumber) {
  // All 40 differences are +1 or -1: the sum is a binomial. R 4.2: pbinom(25, 40, .5, lower.tail = FALSE)
  std::vector<double> d(40, 0.25);
  std::fill(d.begin(), d.begin() + 14, -0.25);
  const SignFlipTest test = sign_flip_test(d);
  EXPECT_TRUE(test.exact);
  EXPECT_EQ(test.resamples, 0);
  EXPECT_NEAR(test.p.greater, 0.0403452338759964, 1e-13);
}

TEST(SignFlip, MonteCarloIsSeededAndNearTheExactValue) {
  // Twice the maize, moved off any grid: exact p of the 30 by the normal limit is not wanted here; the same
  // data on the grid give it.
  std::vector<double> on_grid = kDarwin, off_grid;
  on_grid.insert(on_grid.end(), kDarwin.begin(), kDarwin.end());
  for (std::size_t i = 0; i < on_grid.size(); ++i) {
    off_grid.push_back(on_grid[i] + 1e-4 * std::sqrt(2.0 + static_cast<double>(i)));
  }
  const SignFlipTest exact = sign_flip_test(on_grid), sampled = sign_flip_test(off_grid);
  ASSERT_TRUE(exact.exact);
  ASSERT_FALSE(sampled.exact);
  EXPECT_EQ(sampled.p.greater, sign_flip_test(off_grid).p.greater);
  // standard error sqrt(p(1 - p)/99999), five of them; ties that the shift resolves count less than one more
  const double p = exact.p.greater, error = std::sqrt(p * (1 - p) / 99'999);
  EXPECT_NEAR(sampled.p.greater, p, 6 * error);
  EXPECT_NE(sampled.method.name.find("Monte Carlo with 99999 resamples, seed 20030901, add-one rule"),
            std::string::npos);
}

TEST(SignFlip, NeverSaysZero) {
  std::vector<double> d;
  for (int i = 0; i < 60; ++i) d.push_back(1.0 + std::sqrt(static_cast<double>(i)));
  const SignFlipTest test = sign_flip_test(d);
  EXPECT_FALSE(test.exact);
  EXPECT_EQ(test.p.greater, 1.0 / 100'000);  // the add-one rule
}

TEST(SignFlip, RefusesNothingAndNonsense) {
  EXPECT_THROW(sign_flip_test({}), std::invalid_argument);
  EXPECT_THROW(sign_flip_test(std::vector<double>{1, NAN}), std::invalid_argument);
  EXPECT_EQ(sign_flip_test(std::vector<double>{0, 0, 0}).p.two_sided, 1.0);
}

TEST(ExamineeLevel, IsTheSignFlipTestOfProportionsAgainstHalf) {
  // 6 examinees, 4 trials each: 4 4 3 3 2 4 correct; deviations in quarters 2 2 1 1 0 2.
  // All signs but the zero's are positive: P = 2 of 64 patterns, 1/32.
  const std::vector<ExamineeCount> counts{{4, 4}, {4, 4}, {3, 4}, {3, 4}, {2, 4}, {4, 4}};
  const ExamineeLevelTest test = examinee_level_test(counts, 0.5);
  EXPECT_EQ(test.p.greater, 1.0 / 32);
  EXPECT_NEAR(test.mean_proportion, 20.0 / 24, 1e-15);
  EXPECT_LE(test.interval.upper, 1.0);
}

TEST(ExamineeLevel, CannotSpeakFromOneExaminee) {
  const ExamineeLevelTest test = examinee_level_test(std::vector<ExamineeCount>{{40, 40}}, 0.5);
  EXPECT_EQ(test.p.greater, 0.5);
  EXPECT_EQ(test.interval.lower, 0.0);
  EXPECT_EQ(test.interval.upper, 1.0);
  EXPECT_THROW(examinee_level_test(std::vector<ExamineeCount>{{1, 3}}, 1.0), std::invalid_argument);
}
