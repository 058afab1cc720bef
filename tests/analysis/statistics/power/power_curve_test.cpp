#include "analysis/statistics/power/power_curve.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "analysis/binomial/counts_distribution.hpp"
#include "tests/analysis/support/ask.hpp"

using testing::HasSubstr;

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

TEST(PowerStatistic, RefusesExamineesWithoutAnswers) {
  EXPECT_THAT(refusal_of("power", {{"probability", 0.7}, {"trials", 60}, {"each", 0}}),
              HasSubstr("each is 0; accepted: from 1 to largest (500)"));
}

// P(X >= k) rises with the probability: where that is at or below chance, it is at most alpha.
TEST(PowerStatistic, SaysThatATargetIsNeverReachedAndWhy) {
  for (const auto& [probability, side, place] :
       {std::tuple(0.5, "greater", "is chance itself"), std::tuple(0.5, "two-sided", "is chance itself"),
        std::tuple(0.4, "greater", "is below chance, where the test with side 'greater' does not look"),
        std::tuple(0.6, "less", "is above chance, where the test with side 'less' does not look")}) {
    const Outcome outcome = run_statistic("power", {{"probability", probability}, {"side", side}});
    EXPECT_THAT(outcome.text, HasSubstr("80 % is never reached: the true proportion"));
    EXPECT_THAT(outcome.text, HasSubstr(place));
    EXPECT_THAT(outcome.text, HasSubstr("no number of answers has more power than alpha, 0.05"));
    EXPECT_THAT(outcome.json["never"].get<std::string>(), HasSubstr(place));
  }
  EXPECT_TRUE(run_statistic("power", {{"probability", 0.51}}).json["never"].is_null());
  EXPECT_THAT(run_statistic("power", {{"probability", 0.51}}).text,
              HasSubstr("80 % is reached first with more than 500"));
  EXPECT_TRUE(run_statistic("power", {{"probability", 0.5}, {"target", 0.04}}).json["never"].is_null());
}

// Where examinees differ the test rejects chance more often than it promises.
// R: pnorm(qnorm(0.95)/sqrt(1 + 7*0.3), lower.tail = FALSE) = 0.1750967
TEST(PowerStatistic, SaysWhereThePowerOfUnlikeExamineesGoes) {
  const nlohmann::ordered_json asked = {{"probability", 0.5}, {"each", 8}, {"overdispersion", 0.3}};
  EXPECT_THAT(run_statistic("power", asked).text, HasSubstr("the power goes to 0.1751"));
  EXPECT_NEAR(power_curve({.probability = 0.5, .each = 8, .overdispersion = 0.3}, 8000).power.back(),
              0.1750967, 0.005);  // one tooth of 8000 answers
}

}  // namespace palpate::analysis
