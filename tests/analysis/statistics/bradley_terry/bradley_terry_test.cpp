#include "analysis/statistics/bradley_terry/bradley_terry.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

using namespace palpate::analysis;
using testing::HasSubstr;

namespace {

constexpr const char* kTeams[] = {"Milwaukee", "Detroit",   "Toronto",  "New York",
                                  "Boston",    "Cleveland", "Baltimore"};

// Agresti 2002, table 10.10: American League baseball, 1987; rows won against columns.
std::vector<Comparison> baseball() {
  const long wins[7][7] = {{0, 7, 9, 7, 7, 9, 11}, {6, 0, 7, 5, 11, 9, 9}, {4, 6, 0, 7, 7, 8, 12},
                           {6, 8, 6, 0, 6, 7, 10}, {6, 2, 6, 7, 0, 7, 12}, {4, 4, 5, 6, 6, 0, 6},
                           {2, 4, 1, 3, 1, 7, 0}};
  std::vector<Comparison> games;
  for (int i = 0; i < 7; ++i) {
    for (int j = 0; j < 7; ++j) {
      if (wins[i][j] > 0) games.push_back({kTeams[i], kTeams[j], wins[i][j]});
    }
  }
  return games;
}

const ScaledItem& item(const PairedScaling& result, const std::string& name) {
  for (const ScaledItem& one : result.items) {
    if (one.name == name) return one;
  }
  throw std::out_of_range(name);
}

std::string refusal_of_comparisons(const std::vector<Comparison>& comparisons,
                                   const std::optional<std::string>& reference = {}) {
  try {
    paired_scaling(comparisons, ScaleModel::BradleyTerry, reference);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  ADD_FAILURE() << "it was not refused";
  return "";
}

}  // namespace

TEST(PairedScaling, AgreesWithAgrestiAndROnBaseball) {
  // Agresti 2002, section 10.6.2: estimates to two decimals, G2 = 15.7 with df 15. The digits by R 4.2: y and
  // n, wins and games of the 21 pairs, X with 1 and -1 in each row; m <- glm(cbind(y, n - y) ~ X[, -7] - 1,
  // binomial(), control = list(epsilon = 1e-14)); coef(summary(m)); deviance(m); m$null.deviance -
  // deviance(m)
  const PairedScaling result = paired_scaling(baseball(), ScaleModel::BradleyTerry, "Baltimore");
  const double agresti[] = {1.58, 1.44, 1.29, 1.25, 1.11, 0.68, 0};
  const double values[] = {
      1.5813558767, 1.4364084318, 1.2944851239, 1.2476178451, 1.1076977054, 0.6838527692, 0};
  const double errors[] = {
      0.3432559816, 0.3395685064, 0.3366694014, 0.3358609225, 0.3338782070, 0.3318766727, 0};
  for (int team = 0; team < 7; ++team) {
    EXPECT_NEAR(item(result, kTeams[team]).value, agresti[team], 0.005);
    EXPECT_NEAR(item(result, kTeams[team]).value, values[team], 1e-9);
    EXPECT_NEAR(item(result, kTeams[team]).standard_error, errors[team], 1e-7);
  }
  EXPECT_TRUE(result.converged);
  EXPECT_NEAR(result.goodness_of_fit.chi_squared, 15.73650093, 1e-7);
  EXPECT_EQ(result.goodness_of_fit.degrees_of_freedom, 15);
  EXPECT_NEAR(*result.goodness_of_fit.p, 0.3997768612, 1e-8);
  EXPECT_NEAR(result.equality.chi_squared, 49.69850952 - 15.73650093, 1e-7);
  EXPECT_NEAR(result.log_likelihood, -172.2481759947, 1e-8);
  EXPECT_EQ(item(result, "Detroit").wins, 47);
  EXPECT_EQ(result.comparisons, 273);
}

TEST(PairedScaling, AgreesWithRForThurstonesCaseV) {
  // The same with binomial("probit")
  const PairedScaling result = paired_scaling(baseball(), ScaleModel::ThurstoneV, "Baltimore");
  EXPECT_NEAR(item(result, "Milwaukee").value, 0.9704304582, 1e-9);
  EXPECT_NEAR(item(result, "Milwaukee").standard_error, 0.2030735618, 1e-7);
  EXPECT_NEAR(item(result, "Cleveland").value, 0.4154649813, 1e-9);
  EXPECT_NEAR(item(result, "Cleveland").standard_error, 0.1984255709, 1e-7);
  EXPECT_NEAR(result.goodness_of_fit.chi_squared, 15.67798728, 1e-7);
}

TEST(PairedScaling, CentresItsValuesWithoutAReference) {
  const PairedScaling result = paired_scaling(baseball(), ScaleModel::BradleyTerry);
  double sum = 0;
  for (const ScaledItem& one : result.items) sum += one.value;
  EXPECT_NEAR(sum, 0, 1e-12);
  EXPECT_NEAR(item(result, "Milwaukee").value - item(result, "Boston").value, 1.5813558767 - 1.1076977054,
              1e-9);
  // R: V <- rbind(cbind(vcov(m), 0), 0); C <- diag(7) - 1/7; sqrt(diag(C %*% V %*% C))
  EXPECT_NEAR(item(result, "Milwaukee").standard_error, 0.2074194763, 1e-7);
  EXPECT_NEAR(item(result, "Baltimore").standard_error, 0.2324622960, 1e-7);
}

TEST(PairedScaling, TwoItemsAreAProportion) {
  const PairedScaling result =
      paired_scaling({{"hard", "soft", 30}, {"soft", "hard", 10}}, ScaleModel::BradleyTerry, "soft");
  EXPECT_NEAR(item(result, "hard").value, std::log(3), 1e-12);
  EXPECT_NEAR(item(result, "hard").standard_error, std::sqrt(1.0 / 30 + 1.0 / 10), 1e-9);
  EXPECT_EQ(result.goodness_of_fit.degrees_of_freedom, 0);
  EXPECT_FALSE(result.goodness_of_fit.p);
  const PairedScaling thurstone =
      paired_scaling({{"hard", "soft", 30}, {"soft", "hard", 10}}, ScaleModel::ThurstoneV, "soft");
  EXPECT_NEAR(item(thurstone, "hard").value, 0.674489750196082, 1e-12);  // R: qnorm(.75)
}

TEST(PairedScaling, RecoversWhatWasSimulated) {
  std::mt19937_64 random(5);
  const double truth[] = {0, 0.4, 0.9, 1.5};
  const char* names[] = {"a", "b", "c", "d"};
  std::vector<Comparison> comparisons;
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      std::binomial_distribution<long> wins(2000, 1 / (1 + std::exp(truth[j] - truth[i])));
      const long won = wins(random);
      comparisons.push_back({names[i], names[j], won});
      comparisons.push_back({names[j], names[i], 2000 - won});
    }
  }
  const PairedScaling result = paired_scaling(comparisons, ScaleModel::BradleyTerry, "a");
  for (int i = 1; i < 4; ++i) {
    EXPECT_NEAR(result.items[i].value, truth[i], 3.5 * result.items[i].standard_error);
  }
}

TEST(PairedScaling, NamesTheItemsThatHaveNoCommonScale) {
  EXPECT_THAT(refusal_of_comparisons({{"a", "b", 1}, {"b", "a", 2}, {"c", "d", 1}, {"d", "c", 2}}),
              HasSubstr("no chain of comparisons links a and b with c and d"));
  EXPECT_THAT(refusal_of_comparisons({{"a", "b", 1}, {"b", "a", 2}, {"c", "a", 3}, {"c", "b", 2}}),
              HasSubstr("c never lost to a and b: their distance has no finite estimate"));
  EXPECT_THAT(refusal_of_comparisons({{"b", "c", 1}, {"c", "b", 2}, {"c", "a", 3}, {"b", "a", 2}}),
              HasSubstr("b and c never lost to a:"));
}

TEST(PairedScaling, RefusesWhatIsNoComparison) {
  EXPECT_THAT(refusal_of_comparisons({}), HasSubstr("no comparisons"));
  EXPECT_THAT(refusal_of_comparisons({{"a", "a", 1}}), HasSubstr("'a' is compared with itself"));
  EXPECT_THAT(refusal_of_comparisons({{"a", "b", 0}}), HasSubstr("count is 0"));
  EXPECT_THAT(refusal_of_comparisons({{"a", "b", 1}, {"b", "a", 1}}, "z"),
              HasSubstr("reference is 'z'; accepted: a and b"));
}
