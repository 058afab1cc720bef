#include "analysis/report/primary_power.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "analysis/binomial/binomial_power.hpp"
#include "tests/analysis/report/fixture.hpp"

namespace palpate::analysis {
namespace {

StudyDesign design() {
  return test::study_table(test::like_the_paper()).design;  // 15 examinees, 4 trials each
}

}  // namespace

// Examinees who are all alike: the power of the binomial test of 60 trials.
TEST(PrimaryPower, IsThatOfTheBinomialTestWhenExamineesAreAlike) {
  for (const double p : {0.55, 0.7, 0.9}) {
    EXPECT_NEAR(primary_power(design(), p).power, binomial_power(60, 0.5, p, 0.05, Side::Greater), 1e-12);
  }
  EXPECT_EQ(primary_power(design(), 0.7).standard_error, 0.0);
}

// Python, scipy 1.10: one = betabinom(4, a, b).pmf(range(5)) with a = 0.7*s, b = 0.3*s, s = 1/0.2 - 1; d =
// [1.0]; 15 times d = np.convolve(d, one); d[37:].sum()
TEST(PrimaryPower, FallsWhenExamineesDiffer) {
  EXPECT_NEAR(primary_power(design(), 0.7, 0.2).power, 0.88664137304576, 1e-12);
  EXPECT_LT(primary_power(design(), 0.7, 0.2).power, primary_power(design(), 0.7).power);
}

// Looks after O'Brien and Fleming cost next to nothing: the number for the end is still 37, and early
// rejections use what the discrete test at the end leaves of alpha.
TEST(PrimaryPower, KnowsOfPlannedLooks) {
  StudyDesign looks = design();
  looks.looks = {5, 10, 15};
  looks.spending = "obrien-fleming";
  EXPECT_NE(primary_power(looks, 0.7).power, primary_power(design(), 0.7).power);
  EXPECT_NEAR(primary_power(looks, 0.7).power, primary_power(design(), 0.7).power, 0.01);
  EXPECT_LE(primary_power(looks, 0.5).power, 0.05);
}

// A randomisation test given the answers loses little against the binomial where answers are as often "1" as
// "2".
TEST(PrimaryPower, OfBalancedOrdersIsSimulatedAndSaysSo) {
  StudyDesign balanced = design();
  balanced.interval_order = "balanced";
  balanced.primary = "order-randomisation";
  const Power power = primary_power(balanced, 0.7, 0.0, 1), again = primary_power(balanced, 0.7, 0.0, 1);
  EXPECT_EQ(power.power, again.power);
  EXPECT_EQ(power.studies, 10'000);
  EXPECT_NEAR(power.standard_error, std::sqrt(power.power * (1 - power.power) / 10'000), 1e-15);
  EXPECT_GT(power.power, 0.75);
  EXPECT_LE(primary_power(balanced, 0.5).power, 0.05 + 3 * std::sqrt(0.05 * 0.95 / 10'000));
}

TEST(PrimaryPower, RefusesWhatHasNoPower) {
  EXPECT_THROW(primary_power(design(), 1.0), std::invalid_argument);
  EXPECT_THROW(primary_power(design(), 0.7, 1.0), std::invalid_argument);
  StudyDesign open = design();
  open.trials_per_examinee_per_cell = 0;
  EXPECT_THROW(primary_power(open, 0.7), std::invalid_argument);
}

}  // namespace palpate::analysis
