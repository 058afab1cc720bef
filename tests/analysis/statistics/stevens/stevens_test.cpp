#include "analysis/statistics/stevens/stevens.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

using namespace palpate::analysis;
using testing::HasSubstr;

namespace {

// R 4.2: set.seed(3); ex <- rep(1:6, each = 5); lv <- rep(c(.5, 1, 2, 4, 8), 6); off <- rnorm(6); est <-
// round(exp(off[ex] + .8*log(lv) + rnorm(30, 0, .15)), 2)
std::vector<MagnitudeEstimate> six_examinees() {
  const double estimates[6][5] = {{0.22, 0.45, 0.55, 1.4, 1.8},   {0.36, 0.67, 1.35, 2.31, 3.76},
                                  {0.64, 1.18, 2.71, 4.05, 6.27}, {0.16, 0.31, 0.43, 0.89, 1.49},
                                  {0.83, 1.42, 2.09, 3.11, 7.35}, {0.67, 1.15, 2, 2.96, 6.05}};
  std::vector<MagnitudeEstimate> all;
  for (int examinee = 0; examinee < 6; ++examinee) {
    for (int k = 0; k < 5; ++k) {
      all.push_back({std::to_string(examinee), std::exp2(k - 1), estimates[examinee][k]});
    }
  }
  return all;
}

std::string refusal_of_estimates(const std::vector<MagnitudeEstimate>& estimates) {
  try {
    stevens_fit(estimates);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  ADD_FAILURE() << "it was not refused";
  return "";
}

}  // namespace

TEST(Stevens, AgreesWithRsRegression) {
  // R 4.2: m <- lm(log(est) ~ factor(ex) + log(lv)); summary(m)$coefficients["log(lv)", ]; confint(m); 1 -
  // deviance(m)/deviance(lm(log(est) ~ factor(ex)))
  const StevensFit fit = stevens_fit(six_examinees());
  EXPECT_NEAR(fit.exponent, 0.795307102807, 1e-12);
  EXPECT_NEAR(fit.standard_error, 0.0229499799256, 1e-12);
  EXPECT_NEAR(fit.t, 34.6539345736, 1e-9);
  EXPECT_EQ(fit.degrees_of_freedom, 23);
  EXPECT_NEAR(fit.p / 2.34939473837e-21, 1, 1e-9);
  EXPECT_NEAR(fit.interval.lower, 0.747831452175, 1e-11);
  EXPECT_NEAR(fit.interval.upper, 0.842782753439, 1e-11);
  EXPECT_NEAR(fit.residual_deviation, 0.123220621862, 1e-12);
  EXPECT_NEAR(fit.r_squared, 0.981207541014, 1e-12);
  EXPECT_TRUE(fit.balanced);
}

TEST(Stevens, AgreesWithRsMeans) {
  // exp(tapply(log(est), lv, mean)); s <- sapply(1:6, function(i) coef(lm(log(est) ~ log(lv), subset = ex ==
  // i))[2]); mean(s); sd(s); t.test(s)$conf.int
  const StevensFit fit = stevens_fit(six_examinees());
  const double means[] = {0.406471099463, 0.751483645895, 1.238944202261, 2.179914821702, 3.756869811325};
  ASSERT_EQ(fit.levels.size(), 5U);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(fit.levels[k].geometric_mean, means[k], 1e-11);
  ASSERT_TRUE(fit.by_examinee);
  EXPECT_NEAR(fit.by_examinee->mean, 0.7953071028070, 1e-12);
  EXPECT_NEAR(fit.by_examinee->deviation, 0.0431543680999, 1e-12);
  EXPECT_NEAR(fit.by_examinee->interval.lower, 0.7500193709058, 1e-11);
  EXPECT_NEAR(fit.by_examinee->interval.upper, 0.8405948347082, 1e-11);
}

TEST(Stevens, AgreesWithRWhereDataAreMissing) {
  // The same regression on rows c(1:3, 6:30, 30), 5 levels and 6 examinees as before
  std::vector<MagnitudeEstimate> some = six_examinees();
  some.push_back(some.back());
  some.erase(some.begin() + 3, some.begin() + 5);
  const StevensFit fit = stevens_fit(some);
  EXPECT_NEAR(fit.exponent, 0.796460968035, 1e-12);
  EXPECT_NEAR(fit.standard_error, 0.0227099771398, 1e-12);
  EXPECT_EQ(fit.degrees_of_freedom, 22);
  EXPECT_FALSE(fit.balanced);
  EXPECT_EQ(fit.levels.back().examinees, 5U);
  EXPECT_EQ(fit.levels.back().estimates, 6U);
}

// Exponents of Stevens 1975, table 1: tactual hardness 0.8, heaviness 1.45, electric shock 3.5.
class StevensExponent : public testing::TestWithParam<double> {};

TEST_P(StevensExponent, IsRecoveredFromSimulation) {
  std::mt19937_64 random(9);
  std::normal_distribution<double> normal;
  int held = 0;
  double sum = 0;
  constexpr int kStudies = 300;
  for (int study = 0; study < kStudies; ++study) {
    std::vector<MagnitudeEstimate> estimates;
    for (int examinee = 0; examinee < 8; ++examinee) {
      const double unit = std::exp(2 * normal(random));
      for (int k = 0; k < 6; ++k) {
        const double level = 10 * std::exp2(0.5 * k);
        estimates.push_back({std::to_string(examinee), level,
                             unit * std::pow(level, GetParam()) * std::exp(0.3 * normal(random))});
      }
    }
    const StevensFit fit = stevens_fit(estimates);
    held += fit.interval.lower <= GetParam() && GetParam() <= fit.interval.upper;
    sum += fit.exponent;
  }
  // The model is exact here: 95 % within 3 Monte-Carlo standard errors; one exponent's own error is 0.073.
  EXPECT_NEAR(held / double(kStudies), 0.95, 0.038);
  EXPECT_NEAR(sum / kStudies, GetParam(), 3.5 * 0.073 / std::sqrt(kStudies));
}

INSTANTIATE_TEST_SUITE_P(Senses, StevensExponent, testing::Values(0.8, 1.45, 3.5));

TEST(Stevens, DoesNotDependOnUnits) {
  std::vector<MagnitudeEstimate> changed = six_examinees();
  for (MagnitudeEstimate& one : changed) {
    one.level *= 1000;
    if (one.examinee == "2") one.estimate *= 50;
  }
  EXPECT_NEAR(stevens_fit(changed).exponent, stevens_fit(six_examinees()).exponent, 1e-12);
}

TEST(Stevens, RefusesWhatItCannotAnswer) {
  EXPECT_THAT(refusal_of_estimates({{"a", 1, 0}, {"a", 2, 3}}), HasSubstr("level 1 was judged 0 by 'a'"));
  EXPECT_THAT(refusal_of_estimates({{"a", -1, 2}, {"a", 2, 3}}), HasSubstr("both above 0"));
  EXPECT_THAT(refusal_of_estimates({{"a", 1, 1}, {"a", 1, 2}, {"b", 2, 3}}),
              HasSubstr("no examinee judged two levels"));
  EXPECT_THAT(refusal_of_estimates({{"a", 1, 1}, {"a", 2, 2}}), HasSubstr("none is left over"));
}

// Rounding is no spread: 3 * level^0.7 to the last bit of a double.
TEST(Stevens, GivesNoTestOfAPerfectPowerLaw) {
  std::vector<MagnitudeEstimate> all;
  for (int examinee = 0; examinee < 3; ++examinee)
    for (const double level : {1.0, 2.0, 4.0, 8.0, 11.0})
      all.push_back({std::to_string(examinee), level, (3 + examinee) * std::pow(level, 0.7)});
  const StevensFit fit = stevens_fit(all);
  EXPECT_TRUE(fit.perfect);
  EXPECT_NEAR(fit.exponent, 0.7, 1e-14);
  EXPECT_EQ(fit.standard_error, 0.0);
  EXPECT_TRUE(std::isnan(fit.t) && std::isnan(fit.p) && std::isnan(fit.interval.lower));
  all.back().estimate *= 1 + 1e-5;
  EXPECT_FALSE(stevens_fit(all).perfect);
}
