#include "analysis/psychometric/profile.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/psychometric/measures.hpp"
#include "tests/analysis/psychometric/support.hpp"

using namespace palpate::analysis;

namespace {

Interval interval_of(const std::vector<Block>& blocks, const PsychometricModel& model, Measure measure,
                     double at = 0.5) {
  const Fitter fitter(make_design(blocks, model));
  const auto correct = correct_in(fitter.design(), blocks);
  return profile_interval(fitter, correct, fitter.fit(correct), measure, at, 0.95);
}

}  // namespace

TEST(ProfileInterval, AgreesWithR_optim) {
  // R 4.2: for each value held, optim (Nelder-Mead, reltol 1e-15, three starts) of the same likelihood over
  // the other two parameters; uniroot (tol 1e-8) of its fall by qchisq(.95, 1)/2. Lapse free from 0 to 0.1.
  const PsychometricModel model{.lapse_upper = 0.1};
  const Interval threshold = interval_of(psignifit_blocks(), model, Measure::Level);
  EXPECT_NEAR(threshold.lower, 2.84669502891, 1e-6);
  EXPECT_NEAR(threshold.upper, 4.6711192167, 1e-6);
  const Interval slope = interval_of(psignifit_blocks(), model, Measure::Slope);
  EXPECT_NEAR(slope.lower, 0.129424161703, 1e-6);
  EXPECT_NEAR(slope.upper, 0.457617241422, 1e-6);
  const Interval lapse = interval_of(psignifit_blocks(), model, Measure::Lapse);
  EXPECT_EQ(lapse.lower, 0);
  EXPECT_NEAR(lapse.upper, 0.0456704660642, 1e-6);
}

TEST(ProfileInterval, OfTheSlopeIsR_confintOfGlm) {
  // R 4.2: confint(glm(cbind(k, 50 - k) ~ x, binomial(LINK))), which interpolates: its last digits are rough
  const auto blocks = blocks_from({0, 1, 2, 3, 4}, {5, 14, 24, 40, 45}, 50);
  const Interval logit = interval_of(blocks, {.guess = 0, .lapse_upper = 0}, Measure::Slope);
  EXPECT_NEAR(4 * logit.lower, 0.863842534128, 1e-4);  // the logistic's density at 0 is 1/4
  EXPECT_NEAR(4 * logit.upper, 1.40235895046, 1e-4);
  const Interval cloglog = interval_of(blocks, {.shape = Shape::GumbelLeft, .guess = 0, .lapse_upper = 0},
                                       Measure::Slope, 1 - std::exp(-1.0));
  EXPECT_NEAR(std::exp(1.0) * cloglog.lower, 0.567043582317, 1e-4);  // density 1/e where eta = 0
  EXPECT_NEAR(std::exp(1.0) * cloglog.upper, 0.883168721683, 1e-4);
}

TEST(ProfileInterval, OfHalfTheDistanceIsThatOfTheSlopeTurnedOver) {
  // On plain levels the two differ by a factor: half distance x slope = (q75 - q25)/2 x density at 0.5.
  const auto blocks = psignifit_blocks();
  const Interval slope = interval_of(blocks, {}, Measure::Slope);
  const Interval distance = interval_of(blocks, {}, Measure::HalfDistance);
  EXPECT_NEAR(distance.lower * slope.upper, std::log(3.0) / 4, 1e-6);
  EXPECT_NEAR(distance.upper * slope.lower, std::log(3.0) / 4, 1e-6);
}

TEST(ProfileInterval, HoldsTheWeibullMeasuresAtTheirCut) {
  // Each end has the likelihood that it should, by holding the measure there; the ends differ by measure.
  std::vector<Block> blocks = psignifit_blocks();
  for (Block& block : blocks) block.level += 1;
  const Fitter fitter(make_design(blocks, {.shape = Shape::Weibull}));
  const auto correct = correct_in(fitter.design(), blocks);
  const PsychometricFit fit = fitter.fit(correct);
  for (const Measure measure : {Measure::Level, Measure::Slope, Measure::HalfDistance}) {
    const Interval interval = profile_interval(fitter, correct, fit, measure, 0.5, 0.95);
    for (const double end : {interval.lower, interval.upper}) {
      const double held = profile_log_likelihood(fitter, correct, measure, 0.5, end);
      EXPECT_NEAR(fit.log_likelihood - held, 3.84145882069412 / 2, 1e-6);  // R: qchisq(.95, 1)
    }
  }
}

TEST(ProfileInterval, IsOpenWhereTheAnswersLeaveItOpen) {
  const auto separable = blocks_from({1, 2, 3, 4}, {5, 5, 10, 10}, 10);
  const Interval slope = interval_of(separable, {}, Measure::Slope);
  EXPECT_TRUE(std::isinf(slope.upper));
  EXPECT_GT(slope.lower, 0);
  const Interval threshold = interval_of(separable, {}, Measure::Level);
  EXPECT_LT(threshold.lower, 2);
  EXPECT_GT(threshold.upper, 2.9);
  EXPECT_LT(threshold.upper, 4);
  const auto flat = blocks_from({1, 2, 3, 4}, {7, 8, 7, 8}, 10);
  const Interval any = interval_of(flat, {}, Measure::Level);
  EXPECT_TRUE(std::isinf(any.lower) && std::isinf(any.upper));
  EXPECT_EQ(interval_of(flat, {}, Measure::Slope).lower, 0);
}

TEST(ProfileInterval, CoversAsItPromises) {
  std::mt19937_64 random(20);
  constexpr int kStudies = 500;
  int threshold = 0, slope = 0;
  const PsychometricModel model{.guess = 0.5};
  for (int i = 0; i < kStudies; ++i) {
    const auto blocks = simulated({1, 2, 3, 4, 5, 6}, 80, Shape::Logistic, 0.5, 0.02, 3.3, 1.6, random);
    const Interval level = interval_of(blocks, model, Measure::Level);
    const Interval rise = interval_of(blocks, model, Measure::Slope);
    threshold += level.lower <= 3.3 && 3.3 <= level.upper;
    slope += rise.lower <= 0.4 && 0.4 <= rise.upper;
  }
  // Monte-Carlo standard error sqrt(.95 x .05/500) = 0.0097. Likelihood intervals are right for many trials;
  // a percent of bias at 480 trials is allowed beside four standard errors.
  EXPECT_NEAR(threshold / double(kStudies), 0.95, 0.049);
  EXPECT_NEAR(slope / double(kStudies), 0.95, 0.049);
}
