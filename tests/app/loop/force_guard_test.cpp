#include "app/loop/force_guard.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace palpate::app {
namespace {

constexpr double kStep = 1e-3, kLargest = 10.0;
constexpr GuardTimes kTimes{};
const double kNan = std::numeric_limits<double>::quiet_NaN();

double step(ForceGuard& guard, double force, double age = 0.0, bool finite = true) {
  return guard_force(guard, kTimes, finite, age, force, kLargest, kStep);
}

TEST(ForceGuard, PassesForceAndClampsIt) {
  ForceGuard guard;
  EXPECT_DOUBLE_EQ(step(guard, 3.0), 3.0);
  EXPECT_DOUBLE_EQ(step(guard, 30.0), kLargest);
  EXPECT_DOUBLE_EQ(step(guard, -30.0), -kLargest);
}

class BadForce : public testing::TestWithParam<double> {};

TEST_P(BadForce, RampsToZeroWithin20MillisecondsAndLatches) {
  ForceGuard guard;
  double before = step(guard, 4.0);
  step(guard, GetParam());
  for (int i = 0; i < 19; ++i) {
    const double force = step(guard, 9.0);  // the computation is sound again, and is not trusted
    EXPECT_LE(force, before);               // never up
    before = force;
  }
  EXPECT_EQ(before, 0.0);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(step(guard, 4.0), 0.0);
}

TEST(ForceGuard, ALateCycleRaisesTheForceByOneCycleOnlyAndLowersItByTheTimeThatPassed) {
  ForceGuard guard{.gain = 0.0};
  EXPECT_LE(guard_force(guard, kTimes, true, 0.0, 4.0, kLargest, 0.5), 4.0 * kStep / kTimes.ramp_up + 1e-12);
  guard.gain = 1.0;
  EXPECT_EQ(guard_force(guard, kTimes, true, 1.0, 4.0, kLargest, 0.5), 0.0);
}

INSTANTIATE_TEST_SUITE_P(NotFinite, BadForce,
                         testing::Values(kNan, std::numeric_limits<double>::infinity(),
                                         -std::numeric_limits<double>::infinity()));

TEST(ForceGuard, ABadPoseIsAFaultEvenIfTheForceLooksSound) {
  ForceGuard guard;
  step(guard, 4.0, 0.0, false);
  EXPECT_EQ(guard.fault, Fault::NotFinite);
}

TEST(ForceGuard, AGapOf500MillisecondsIsNoKick) {
  ForceGuard guard;
  double before = step(guard, 4.0), largest_rise = 0.0;
  for (int i = 1; i <= 500; ++i) before = step(guard, 4.0, i * kStep);
  EXPECT_EQ(before, 0.0);
  for (int i = 0; i < 200; ++i) {
    const double force = step(guard, 4.0);
    largest_rise = std::max(largest_rise, force - before);
    before = force;
  }
  EXPECT_EQ(guard.fault, Fault::None);
  EXPECT_DOUBLE_EQ(before, 4.0);
  EXPECT_LE(largest_rise, 4.0 * kStep / kTimes.ramp_up + 1e-12);
}

}  // namespace
}  // namespace palpate::app
