#include "devices/mouse/pseudo_haptic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace palpate::devices {
namespace {

constexpr double kTick = 1e-3;  // [s]
constexpr double kHand = 8e-3;  // [m]

using Tissue = std::function<double(double depth)>;  // force against the press [N]

/// The depths of a press held at kHand for a second and a half.
std::vector<double> held_press(const Tissue& tissue, const PseudoHapticCoupling& coupling = {}) {
  DrivenProbe probe;
  std::vector<double> depths;
  for (int i = 0; i < 1500; ++i) {
    follow_hand(coupling, probe, kHand, tissue(probe.depth), kTick);
    depths.push_back(probe.depth);
  }
  return depths;
}

Tissue linear(double stiffness) {
  return [stiffness](double depth) { return std::max(0.0, stiffness * depth); };
}

class HeldAgainst : public testing::TestWithParam<double> {};

// k_c (h - x) = K x has the root x = h k_c / (k_c + K), whatever K.
TEST_P(HeldAgainst, LinearTissueRestsWhereTheSpringBalances) {
  const double stiffness = GetParam(), spring = PseudoHapticCoupling{}.spring;
  const auto depths = held_press(linear(stiffness));
  const double balance = kHand * spring / (spring + stiffness);
  EXPECT_NEAR(depths.back(), balance, 1e-9 + 1e-9 * balance);  // 150 time constants have passed
}

TEST_P(HeldAgainst, NeverOvershootsNorTrembles) {
  const double stiffness = GetParam(), spring = PseudoHapticCoupling{}.spring;
  const double balance = kHand * spring / (spring + stiffness);
  const auto depths = held_press(linear(stiffness));
  // In the first step no force is known yet, and the probe moves a tenth (dt/tau) of the hand's way.
  EXPECT_LE(depths[0], 0.1 * 0.5e-3);
  for (std::size_t i = 2; i < depths.size(); ++i) {
    EXPECT_GE(depths[i], depths[i - 1] - 1e-12) << "step " << i;
    EXPECT_LE(depths[i], balance + 1e-12) << "step " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Stiffnesses, HeldAgainst, testing::Values(0.0, 1.0, 3e3, 1e4, 1e5, 1e6));

// An explicit step is unstable from K = (2 tau / dt - 1) k_c on; this one may not be for any K.
TEST(PseudoHaptic, StaysBoundedForAnyStiffness) {
  for (double stiffness = 1e-3; stiffness < 1e13; stiffness *= 10)
    for (const double depth : held_press(linear(stiffness))) {
      ASSERT_TRUE(std::isfinite(depth));
      ASSERT_LE(std::abs(depth), 1.01 * kHand) << stiffness << " N/m";
    }
}

// Stiffer behind than before: the secant to rest alone underrates it 1000 times.
TEST(PseudoHaptic, SettlesOnTissueThatStiffensSuddenly) {
  const double spring = PseudoHapticCoupling{}.spring;
  const Tissue tissue = [](double x) { return std::max(0.0, 100 * x) + std::max(0.0, 1e5 * (x - 4e-3)); };
  const auto depths = held_press(tissue);
  // k_c (h - x) = 100 x + 1e5 (x - 4 mm), solved by hand for x.
  EXPECT_NEAR(depths.back(), (spring * kHand + 1e5 * 4e-3) / (spring + 100 + 1e5), 1e-8);
}

// The paper's contact laws jump when a pair comes or goes. Here the spring pulls with 40 N at 4 mm, where the
// tissue's force goes from 36 to 44 N: there is no rest point. The probe then stays within what one free step
// can move it.
TEST(PseudoHaptic, AJumpOfTheForceIsNoKick) {
  const Tissue tissue = [](double x) { return 9e3 * std::max(0.0, x) + (x > 4e-3 ? 8.0 : 0.0); };
  const auto depths = held_press(tissue);
  for (std::size_t i = depths.size() / 2; i < depths.size(); ++i) {
    EXPECT_NEAR(depths[i], 4e-3, 0.5e-3);
    EXPECT_LE(std::abs(depths[i] - depths[i - 1]), 0.5e-3);
  }
}

TEST(PseudoHaptic, FreeHandIsFollowedWithTheStatedLag) {
  const PseudoHapticCoupling coupling{.largest_hand_speed = 1e3};
  DrivenProbe probe;
  const int steps = static_cast<int>(std::lround(coupling.lag_time / kTick));
  for (int i = 0; i < steps; ++i) follow_hand(coupling, probe, -kHand, 0.0, kTick);
  // Implicit Euler of tau x' = h - x over one tau: h (1 - (1 + dt/tau)^-n), near h (1 - 1/e).
  EXPECT_NEAR(probe.depth / -kHand, 1 - std::pow(1 + kTick / coupling.lag_time, -steps), 1e-12);
}

TEST(PseudoHaptic, TheProbeGoesNoDeeperThanTheSceneWhileTheHandGoesOn) {
  DrivenProbe probe{.deepest = 5e-3};
  for (int i = 0; i < 100; ++i) follow_hand({}, probe, 9e-3, 0.0, kTick);
  EXPECT_EQ(probe.depth, 5e-3);
  EXPECT_EQ(probe.hand, 9e-3);
}

TEST(PseudoHaptic, AHandThatJumpsIsFollowedNoFasterThanStated) {
  DrivenProbe probe;
  follow_hand({}, probe, 1.0, 0.0, kTick);
  EXPECT_DOUBLE_EQ(probe.hand, 0.5 * kTick);
}

TEST(PseudoHaptic, StifferTissueLagsMore) {
  EXPECT_GT(held_press(linear(8e3)).back(), held_press(linear(9e3)).back());
}

}  // namespace
}  // namespace palpate::devices
