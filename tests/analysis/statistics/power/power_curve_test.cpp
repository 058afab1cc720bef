#include "analysis/statistics/power/power_curve.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "analysis/binomial/counts_distribution.hpp"

namespace palpate::analysis {

// The search by multiples of 4 answers, done again by the function that steps through sizes by itself.
TEST(PowerCurve, FindsTheSizesThatTheSearchFinds) {
  const PowerCurve curve = power_curve({.probability = 0.65, .each = 4}, 2004);
  const SampleSize size = binomial_sample_size(0.5, 0.65, 0.05, Side::Greater, 0.8, 4, 2004);
  EXPECT_EQ(curve.size.first, size.first);
  EXPECT_EQ(curve.size.lasting, size.lasting);
  EXPECT_EQ(curve.power[14], binomial_power(60, 0.5, 0.65, 0.05, Side::Greater));
}

// The sawtooth of R, n = 4..12: sapply(4:12, function(n) pbinom(qbinom(0.95, n, 0.5), n, 0.75, lower.tail =
// FALSE))
TEST(PowerCurve, IsASawtooth) {
  const PowerCurve curve = power_curve({.probability = 0.75}, 12);
  const std::vector<double> expected{0,
                                     0.2373046875,
                                     0.177978515625,
                                     0.13348388671875,
                                     0.367080688476562,
                                     0.300338745117187,
                                     0.244025230407715,
                                     0.455200910568238,
                                     0.390675008296967};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(curve.power[i + 3], expected[i], 1e-12) << i + 4;
  EXPECT_LT(curve.power[5], curve.power[4]);  // six answers have less power than five
}

// scipy: betabinom(4, 0.7*4, 0.3*4).pmf(range(5)), overdispersion 0.2
TEST(BetaBinomialCounts, AreThoseOfScipy) {
  const std::vector<double> counts = beta_binomial_counts(4, 0.7, 0.2),
                            expected{0.04224, 0.11264000000000009, 0.20064000000000004, 0.2918399999999999,
                                     0.35264};
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(counts[k], expected[k], 1e-12);
}

TEST(PowerCurve, RefusesWhatIsNoQuestion) {
  EXPECT_THROW(power_curve({.probability = 1.0}, 100), std::invalid_argument);
  EXPECT_THROW(power_curve({.overdispersion = 1.0}, 100), std::invalid_argument);
  EXPECT_THROW(power_curve({.each = 0}, 100), std::invalid_argument);
  EXPECT_THROW(power_curve({.each = 8}, 4), std::invalid_argument);
}

}  // namespace palpate::analysis
