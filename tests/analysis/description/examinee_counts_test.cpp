#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis/support/ask.hpp"

using namespace palpate::analysis;
using testing::HasSubstr;

namespace {

nlohmann::ordered_json asked(const std::vector<long>& correct, const std::vector<long>& trials) {
  return {{"data", {{"correct", correct}, {"trials", trials}}}};
}

}  // namespace

TEST(ExamineeLevelStatistic, AgreesWithScipy) {
  // python3, scipy 1.10: d = np.array([.8, .7, .9, .5, .6, .8]) - .5; stats.permutation_test((d,), np.mean,
  // permutation_type="samples", alternative="greater").pvalue: 0.03125; d.mean()/d.std(ddof=1):
  // 1.4719601443879742
  const auto json = run_statistic("examinee-level", asked({8, 7, 9, 5, 6, 8}, {10, 10, 10, 10, 10, 10})).json;
  EXPECT_NEAR(json["p"].get<double>(), 0.03125, 1e-15);
  EXPECT_NEAR(json["standardised_mean"].get<double>(), 1.4719601443879742, 1e-12);
  EXPECT_EQ(json["side"], "greater");
}

TEST(BetaBinomialStatistic, SaysWhereSpreadCannotBeTold) {
  const Outcome outcome = run_statistic("beta-binomial", asked({4, 5, 3}, {10, 10, 10}));
  EXPECT_TRUE(outcome.json["gamma"]["estimate"].is_null());
  EXPECT_TRUE(outcome.json["mean"]["standard_error"].is_null());
  EXPECT_THAT(outcome.text, HasSubstr("cannot be told"));
}

TEST(ExamineeCounts, AreRefusedWithTheirRow) {
  EXPECT_THAT(refusal_of("beta-binomial", asked({4, 11}, {10, 10})), HasSubstr("data:2: 11 of 10 correct"));
  EXPECT_THAT(refusal_of("examinee-level", asked({4, 0}, {10, 0})), HasSubstr("data:2: 0 of 0 correct"));
}
