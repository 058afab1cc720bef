#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "analysis/numerics/infinity.hpp"
#include "analysis/psychometric/bayes.hpp"
#include "analysis/psychometric/compare.hpp"
#include "analysis/psychometric/measures.hpp"
#include "analysis/psychometric/profile.hpp"
#include "tests/analysis/psychometric/support.hpp"

// The same answers at levels in another unit, counted from another origin: whatever is said in the unit of the
// level goes along, all else stays.

using namespace palpate::analysis;

namespace {

struct Change {
  double unit = 1.0, origin = 0.0;

  double operator()(double level) const { return origin + unit * level; }
  std::vector<Block> operator()(std::vector<Block> blocks) const {
    for (Block& block : blocks) block.level = (*this)(block.level);
    return blocks;
  }
};

// Units over 24 powers of ten, origins up to a thousand units away: levels keep 13 digits of where they stand.
std::vector<Change> changes(bool with_origin) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> power(-12, 12), origin(-1000, 1000);
  std::vector<Change> all;
  for (int i = 0; i < 6; ++i) {
    Change change{.unit = std::pow(10.0, power(random))};
    if (with_origin) change.origin = origin(random) * change.unit;
    all.push_back(change);
  }
  return all;
}

struct Found {
  PsychometricFit fit{};
  Interval level{}, slope{}, half_distance{}, lapse{};
};

Found found_in(const std::vector<Block>& blocks, const PsychometricModel& model) {
  const Fitter fitter(make_design(blocks, model));
  const std::vector<double> correct = correct_in(fitter.design(), blocks);
  const PsychometricFit fit = fitter.fit(correct);
  const auto interval = [&](Measure measure) {
    return profile_interval(fitter, correct, fit, measure, 0.5, 0.95);
  };
  return {.fit = fit,
          .level = interval(Measure::Level),
          .slope = interval(Measure::Slope),
          .half_distance = interval(Measure::HalfDistance),
          .lapse = interval(Measure::Lapse)};
}

const std::vector<std::vector<Block>> kAnswers{
    blocks_from({1, 2, 3, 4, 5, 6}, {26, 30, 38, 46, 49, 50}, 50),
    blocks_from({1, 2, 3, 4, 5, 6}, {27, 24, 31, 30, 36, 33}, 50),  // open slopes
    blocks_from({1, 2, 3, 4, 5, 6}, {5, 5, 6, 10, 10, 10}, 10)};    // open steepness

const std::vector<PsychometricCondition> kConditions{
    {"a", blocks_from({1, 2, 3, 4, 5, 6}, {5, 14, 24, 40, 45, 49}, 50)},
    {"b", blocks_from({1, 2, 3, 4, 5, 6}, {2, 8, 20, 30, 44, 48}, 50)}};

// Equal to 1e-8 of `scale`, infinities to themselves.
void expect_ends(const Interval& found, double lower, double upper, double scale) {
  const auto expect = [&](double end, double wanted) {
    if (std::isinf(wanted)) {
      EXPECT_EQ(end, wanted);
    } else {
      EXPECT_NEAR(end / scale, wanted / scale, 1e-8);
    }
  };
  expect(found.lower, lower);
  expect(found.upper, upper);
}

}  // namespace

TEST(UnitAndOrigin, OfTheLevelDecideNothingOfAFit) {
  for (const Shape shape : {Shape::Logistic, Shape::Gaussian, Shape::GumbelLeft, Shape::GumbelRight}) {
    const PsychometricModel model{.shape = shape};
    for (const std::vector<Block>& blocks : kAnswers) {
      const Found here = found_in(blocks, model);
      for (const Change& change : changes(true)) {
        SCOPED_TRACE(testing::Message()
                     << name_of(shape) << ", unit " << change.unit << ", origin " << change.origin);
        const Found there = found_in(change(blocks), model);
        EXPECT_EQ(there.fit.kind, here.fit.kind);
        EXPECT_NEAR(there.fit.log_likelihood, here.fit.log_likelihood, 1e-10);
        expect_ends(there.level, change(here.level.lower), change(here.level.upper), change.unit);
        expect_ends(there.slope, here.slope.lower / change.unit, here.slope.upper / change.unit,
                    1 / change.unit);
        expect_ends(there.half_distance, here.half_distance.lower * change.unit,
                    here.half_distance.upper * change.unit, change.unit);
        expect_ends(there.lapse, here.lapse.lower, here.lapse.upper, 1.0);
      }
    }
  }
}

// The Weibull function starts at level 0: its unit alone is free.
TEST(UnitAndOrigin, UnitOfTheLevelDecidesNothingOfAWeibullFunction) {
  const PsychometricModel model{.shape = Shape::Weibull};
  const Found here = found_in(kAnswers[0], model);
  for (const Change& change : changes(false)) {
    SCOPED_TRACE(change.unit);
    const Found there = found_in(change(kAnswers[0]), model);
    expect_ends(there.level, change(here.level.lower), change(here.level.upper), change.unit);
    expect_ends(there.slope, here.slope.lower / change.unit, here.slope.upper / change.unit, 1 / change.unit);
    expect_ends(there.half_distance, here.half_distance.lower * change.unit,
                here.half_distance.upper * change.unit, change.unit);
  }
}

TEST(UnitAndOrigin, APowerOfTwoForAUnitChangesNoBit) {
  for (const double unit : {0x1p-30, 0x1p-1, 0x1p40}) {
    const Change change{.unit = unit};
    const Found here = found_in(kAnswers[0], {}), there = found_in(change(kAnswers[0]), {});
    EXPECT_EQ(there.fit.alpha, here.fit.alpha * unit);
    EXPECT_EQ(there.fit.beta, here.fit.beta / unit);
    EXPECT_EQ(there.level.lower, here.level.lower * unit);
    EXPECT_EQ(there.slope.lower, here.slope.lower / unit);
    EXPECT_EQ(there.slope.upper, here.slope.upper / unit);
    EXPECT_EQ(there.half_distance.upper, here.half_distance.upper * unit);
  }
}

TEST(UnitAndOrigin, OfTheLevelDecideNothingOfAComparison) {
  for (const Same same : {Same::Function, Same::Threshold, Same::Slope}) {
    const PsychometricComparison here = compare_psychometric(kConditions, kNoGuess, same);
    for (const Change& change : changes(true)) {
      SCOPED_TRACE(testing::Message()
                   << name_of(same) << ", unit " << change.unit << ", origin " << change.origin);
      std::vector<PsychometricCondition> conditions = kConditions;
      for (PsychometricCondition& one : conditions) one.blocks = change(one.blocks);
      const PsychometricComparison there = compare_psychometric(conditions, kNoGuess, same);
      EXPECT_NEAR(there.chi_squared, here.chi_squared, 1e-9);
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(there.same.alpha[i] / change.unit, change(here.same.alpha[i]) / change.unit, 1e-6);
        EXPECT_NEAR(there.same.beta[i] * change.unit, here.same.beta[i], 1e-6);
      }
    }
  }
}

TEST(UnitAndOrigin, OfTheLevelDecideNothingOfAPosterior) {
  const BayesianFit here = bayesian_psychometric(kAnswers[0], Shape::Gaussian, 0.5, 0.95);
  for (const Change& change : {Change{.unit = 1e-8}, Change{.unit = 3e7, .origin = 1e9}}) {
    SCOPED_TRACE(change.unit);
    const BayesianFit there = bayesian_psychometric(change(kAnswers[0]), Shape::Gaussian, 0.5, 0.95);
    EXPECT_NEAR(there.threshold.mean / change.unit, change(here.threshold.mean) / change.unit, 1e-8);
    EXPECT_NEAR(there.threshold.mode / change.unit, change(here.threshold.mode) / change.unit, 1e-5);
    EXPECT_NEAR(there.width.mode / change.unit, here.width.mode, 1e-5);
    expect_ends(there.threshold.interval, change(here.threshold.interval.lower),
                change(here.threshold.interval.upper), change.unit);
    expect_ends(there.width.interval, here.width.interval.lower * change.unit,
                here.width.interval.upper * change.unit, change.unit);
    EXPECT_NEAR(there.lapse.mean, here.lapse.mean, 1e-8);
  }
}
