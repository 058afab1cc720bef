#include "trials/adaptive/psychometric.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace palpate::trials::test {

TEST(Psychometric, AtThresholdTheShareIsThatOfTheFunction) {
  const PsychometricParameters at{.threshold = -20, .slope = 3.5, .guess = 0.5, .lapse = 0.02};
  EXPECT_NEAR(share_correct(PsychometricFunction::WeibullDb, -20, at), 0.98 - 0.48 * std::exp(-1.0), 1e-15);
  EXPECT_NEAR(share_correct(PsychometricFunction::Normal, -20, at), 0.74, 1e-15);
  EXPECT_NEAR(share_correct(PsychometricFunction::Logistic, -20, at), 0.74, 1e-15);
}

TEST(Psychometric, OneUnitOfSlopeFurtherOn) {
  const PsychometricParameters at{.threshold = 1, .slope = 2};
  EXPECT_NEAR(share_correct(PsychometricFunction::Normal, 1.5, at), 0.841344746068543, 1e-14);  // Phi(1)
  EXPECT_NEAR(share_correct(PsychometricFunction::Logistic, 1.5, at), 1 / (1 + std::exp(-1.0)), 1e-15);
  EXPECT_NEAR(share_correct(PsychometricFunction::WeibullDb, 11, at), 1 - std::exp(-10.0),
              1e-15);  // 10^(2 * 10 / 20)
}

TEST(Psychometric, AYesOrNoIsAtMostOneBit) {
  EXPECT_EQ(binary_entropy(0.5), 1.0);
  EXPECT_EQ(binary_entropy(0.0), 0.0);
  EXPECT_EQ(binary_entropy(1.0), 0.0);
  EXPECT_NEAR(binary_entropy(0.25), 2.0 - 0.75 * std::log2(3.0), 1e-15);
}

RC_GTEST_PROP(Psychometric, TheShareRisesFromGuessesToLessThanLapses, ()) {
  const auto function = *rc::gen::element(PsychometricFunction::WeibullDb, PsychometricFunction::Normal,
                                          PsychometricFunction::Logistic);
  const double low = *rc::gen::inRange(-500, 500) / 10.0, step = *rc::gen::inRange(0, 500) / 10.0;
  const PsychometricParameters at{.threshold = *rc::gen::inRange(-50, 50) + 0.0,
                                  .slope = *rc::gen::inRange(1, 100) / 10.0,
                                  .guess = 0.25,
                                  .lapse = 0.05};
  const double lower = share_correct(function, low, at), higher = share_correct(function, low + step, at);
  RC_ASSERT(lower >= 0.25);
  RC_ASSERT(higher <= 0.95 + 1e-15);
  RC_ASSERT(lower <= higher);
}

}  // namespace palpate::trials::test
