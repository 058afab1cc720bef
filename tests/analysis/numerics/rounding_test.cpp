#include "analysis/numerics/rounding.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "analysis/statistics/sign/sign_test.hpp"
#include "analysis/statistics/wilcoxon/signed_rank.hpp"
#include "tests/analysis/support/ask.hpp"

using namespace palpate::analysis;
using testing::HasSubstr;

namespace {

// a - b of proportions of ten: seven different magnitudes as decimals, more of them as doubles.
const std::vector<std::pair<int, int>> kTenths{{3, 2}, {9, 8}, {1, 2}, {7, 4}, {6, 3}, {2, 5},
                                               {4, 4}, {8, 6}, {3, 1}, {1, 6}, {9, 4}, {7, 7}};

std::vector<double> subtracted(double unit) {
  std::vector<double> differences;
  for (const auto& [a, b] : kTenths) differences.push_back(a * unit - b * unit);
  return differences;
}

}  // namespace

TEST(Rounding, OfDifferencesHidesNoTie) {
  const SignedRankTest whole = signed_rank_test(subtracted(1), Zeros::Pratt),
                       tenths = signed_rank_test(subtracted(0.1), Zeros::Pratt);
  EXPECT_EQ(tenths.v, whole.v);
  EXPECT_EQ(tenths.zeros, whole.zeros);
  EXPECT_EQ(tenths.p.two_sided, whole.p.two_sided);
}

TEST(Rounding, OfDifferencesHidesNoZero) {
  const std::vector<double> differences{0.3 - 0.2 - 0.1, 0.5, 0.7 - 0.4, 0.2};
  ASSERT_NE(differences[0], 0);
  EXPECT_EQ(sign_test(differences).zeros, 1);
  EXPECT_EQ(sign_test(differences).positive, 3);
}

TEST(Rounding, LeavesApartWhatIsApart) {
  const std::vector<double> apart{1e9, 1e9 + 1, -1e9 - 2, 1e-2};
  EXPECT_EQ(settled_differences(apart), apart);
  EXPECT_EQ(settled_values(apart), apart);
  EXPECT_EQ(settled_values(std::vector<double>{0.1 + 0.2, 0.3, 0.4}), (std::vector<double>{0.3, 0.3, 0.4}));
  EXPECT_EQ(settled_differences(std::vector<double>{-0.1, 0.3 - 0.2})[0],
            -settled_differences(std::vector<double>{-0.1, 0.3 - 0.2})[1]);
  EXPECT_EQ(settled_differences(std::vector<double>{0, 0}), (std::vector<double>{0, 0}));
}

TEST(Rounding, MakesNoTOfEqualDifferences) {
  const nlohmann::ordered_json thirds = {{"difference", {0.29999999999999993, 0.3, 0.30000000000000004}}};
  EXPECT_THAT(refusal_of("ttest", {{"data", thirds}}),
              HasSubstr("all differences are 0.29999999999999993 but for rounding"));
  EXPECT_TRUE(run_statistic("permutation", {{"data", thirds}}).json["interval"]["lower"].is_null());
  const nlohmann::ordered_json alike = {{"correct", {7, 14, 21, 7, 7, 7}},
                                        {"trials", {10, 20, 30, 10, 10, 10}}};
  EXPECT_TRUE(run_statistic("examinee-level", {{"data", alike}}).json["standardised_mean"].is_null());
}

// R 4.2: friedman.test(rbind(c(3,3,4), c(2,3,3), c(1,2,3), c(1,3,3)))$statistic
TEST(Rounding, OfValuesHidesNoTie) {
  const auto whole =
      run_statistic("friedman", {{"data", {{"a", {3, 2, 1, 1}}, {"b", {3, 3, 2, 3}}, {"c", {4, 3, 3, 3}}}}});
  const auto tenths = run_statistic("friedman", {{"data",
                                                  {{"a", {0.1 + 0.2, 0.2, 0.1, 0.1}},
                                                   {"b", {0.3, 0.1 + 0.2, 0.2, 0.3}},
                                                   {"c", {0.4, 0.3, 0.3, 0.1 + 0.2}}}}});
  EXPECT_EQ(tenths.json["chi_squared"], whole.json["chi_squared"]);
  EXPECT_NEAR(tenths.json["chi_squared"], 6.615385, 1e-6);
}

// 0.1 + 0.2 and 0.3 are one level.
TEST(Rounding, MakesNoLevelsOfOne) {
  const auto answers = [](double third) {
    return nlohmann::ordered_json{{"level", {0.1, 0.2, 0.3, third, 0.4}},
                                  {"correct", {6, 6, 4, 4, 10}},
                                  {"trials", {10, 10, 5, 5, 10}}};
  };
  const auto one = run_statistic("psychometric", {{"data", answers(0.3)}, {"replicates", 0}});
  const auto other = run_statistic("psychometric", {{"data", answers(0.1 + 0.2)}, {"replicates", 0}});
  EXPECT_EQ(one.json["slope"], other.json["slope"]);
}
