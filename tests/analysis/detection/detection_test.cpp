#include "analysis/detection/detection.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/detection/detection_rates.hpp"

using namespace palpate::analysis;

namespace {

constexpr auto kNone = DPrimeCorrection::None;

// Rates as counts of a hundred.
Detection same_different_at(int hit_percent, int alarm_percent, Strategy strategy) {
  return same_different({hit_percent, 100, alarm_percent, 100}, strategy, kNone);
}

}  // namespace

TEST(YesNo, AgreesWithR) {
  const Detection d = yes_no({20, 30, 8, 30}, DPrimeCorrection::LogLinear);
  // R 4.2: H <- 20.5/31; F <- 8.5/31; qnorm(H) - qnorm(F); -(qnorm(H) + qnorm(F))/2
  EXPECT_NEAR(d.d_prime, 1.01616599617952, 1e-12);
  EXPECT_NEAR(d.criterion, 0.0920957779000854, 1e-12);
  // sqrt(H*(1 - H)/(30*dnorm(qnorm(H))^2) + F*(1 - F)/(30*dnorm(qnorm(F))^2))
  EXPECT_NEAR(d.standard_error, 0.339895756093246, 1e-12);
  EXPECT_TRUE(d.corrected);
}

TEST(YesNo, HasTheProfileIntervalOfProbitRegression) {
  // R 4.2: confint(glm(cbind(c(20, 8), c(10, 22)) ~ c(.5, -.5), family = binomial("probit"))), which
  // interpolates the profile: 0.39364, 1.73275; solved with uniroot on optimize: the figures here.
  const Interval interval = yes_no({20, 30, 8, 30}, DPrimeCorrection::LogLinear).interval;
  EXPECT_NEAR(interval.lower, 0.393630939155088, 1e-6);
  EXPECT_NEAR(interval.upper, 1.73272804991479, 1e-6);
  // Every signal found: R 4.2, the same, 20 of 20 and 8 of 30.
  const Interval perfect = yes_no({20, 20, 8, 30}, kNone).interval;
  EXPECT_NEAR(perfect.lower, 1.85406333029137, 1e-6);
  EXPECT_TRUE(std::isinf(perfect.upper));
}

TEST(YesNo, KnowsNothingWhereEveryAnswerIsYes) {
  const Detection d = yes_no({20, 20, 30, 30}, kNone);
  EXPECT_TRUE(std::isnan(d.d_prime));
  EXPECT_TRUE(std::isinf(d.interval.lower) && std::isinf(d.interval.upper));
  EXPECT_NEAR(yes_no({20, 20, 30, 30}, DPrimeCorrection::LogLinear).criterion, -2.06, 0.02);
}

TEST(YesNo, TurnsAroundWithTheAnswers) {
  const Detection one = yes_no({20, 30, 8, 25}, DPrimeCorrection::HalfTrial);
  const Detection other = yes_no({10, 30, 17, 25}, DPrimeCorrection::HalfTrial);
  EXPECT_NEAR(one.d_prime, -other.d_prime, 1e-12);
  EXPECT_NEAR(one.criterion, -other.criterion, 1e-12);
  EXPECT_NEAR(one.interval.lower, -other.interval.upper, 1e-6);
}

TEST(SameDifferent, AgreesWithPalamedes) {
  // Palamedes, example of PAL_SDT_1AFCsameDiff_DiffMod_PHFtoDP([.6 .1; .7 .1; .8 .5]): d' and k.
  const double differencing[][4] = {
      {60, 10, 2.6837, 2.3262}, {70, 10, 3.0675, 2.3262}, {80, 50, 2.0629, 0.9539}};
  for (const auto& [hits, alarms, d_prime, k] : differencing) {
    const Detection d = same_different_at(int(hits), int(alarms), Strategy::Differencing);
    EXPECT_NEAR(d.d_prime, d_prime, 1e-4);
    EXPECT_NEAR(d.criterion, k, 1e-4);
  }
  // PAL_SDT_1AFCsameDiff_IndMod_PHFtoDP([0.6 0.1; 0.8 0.1; 0.9 0.6]): d' and c.
  const double independent[][4] = {
      {60, 10, 2.2835, 0.5141}, {80, 10, 2.8342, 0.2200}, {90, 60, 1.7808, -0.7674}};
  for (const auto& [hits, alarms, d_prime, c] : independent) {
    const Detection d = same_different_at(int(hits), int(alarms), Strategy::IndependentObservations);
    EXPECT_NEAR(d.d_prime, d_prime, 1e-4);
    EXPECT_NEAR(d.criterion, c, 1e-4);
  }
}

TEST(SameDifferent, AgreesWithR) {
  // R 4.2: rt <- function(d, k) c(pnorm((d - k)/sqrt(2)) + pnorm((-d - k)/sqrt(2)), 2*pnorm(-k/sqrt(2)));
  // d' by uniroot; standard error by central differences of it over H and F with step 1e-4; the interval by
  // uniroot on 2*(top - optimize(likelihood over k)) - qchisq(.95, 1). For 24 of 30 and 9 of 30.
  const Detection differencing = same_different({24, 30, 9, 30}, Strategy::Differencing, kNone);
  EXPECT_NEAR(differencing.d_prime, 2.64680827384575, 1e-11);
  EXPECT_NEAR(differencing.standard_error, 0.45857454012722, 1e-6);
  EXPECT_NEAR(differencing.interval.lower, 1.73261013847344, 1e-6);
  EXPECT_NEAR(differencing.interval.upper, 3.56475885908659, 1e-6);
  // The same with p(c) <- pnorm(d/2)^2 + pnorm(-d/2)^2 and hit and false-alarm z of ±qnorm(p(c)) - c.
  const Detection independent = same_different({24, 30, 9, 30}, Strategy::IndependentObservations, kNone);
  EXPECT_NEAR(independent.d_prime, 2.12026169076358, 1e-11);
  EXPECT_NEAR(independent.standard_error, 0.346734860951236, 1e-6);
  EXPECT_NEAR(independent.interval.lower, 1.40345776158334, 1e-6);
  EXPECT_NEAR(independent.interval.upper, 2.79183564614282, 1e-6);
}

TEST(SameDifferent, IsZeroWhereDifferentComesNoMoreOftenToPairsThatDiffer) {
  for (const Strategy strategy : {Strategy::Differencing, Strategy::IndependentObservations}) {
    const Detection d = same_different({9, 30, 12, 30}, strategy, kNone);
    EXPECT_EQ(d.d_prime, 0);
    EXPECT_TRUE(std::isinf(d.standard_error));
    EXPECT_EQ(d.interval.lower, 0);
    EXPECT_GT(d.interval.upper, 0.3);
    EXPECT_LT(d.interval.upper, 2);
  }
}

TEST(SameDifferent, FindsTheDPrimeThatMadeTheRates) {
  for (const double d_prime : {0.8, 1.5, 3.0}) {
    const DetectionRates rates = differencing_rates(d_prime, 1.2);
    const auto of_a_million = [](double rate) { return std::lround(1e6 * rate); };
    const Detection d =
        same_different({of_a_million(rates.hit), 1'000'000, of_a_million(rates.false_alarm), 1'000'000},
                       Strategy::Differencing, kNone);
    EXPECT_NEAR(d.d_prime, d_prime, 2e-5);  // counts are rounded
    EXPECT_LT(d.interval.lower, d_prime);
    EXPECT_GT(d.interval.upper, d_prime);
    EXPECT_NEAR(rates.hit + rates.miss, 1, 1e-14);
    EXPECT_NEAR(rates.false_alarm + rates.rejection, 1, 1e-14);
  }
}
