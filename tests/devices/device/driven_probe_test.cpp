#include "devices/device/driven_probe.hpp"

#include <gtest/gtest.h>

namespace palpate::devices {
namespace {

constexpr double kTick = 1e-3;  // [s]

TEST(HoldProbe, TheProbeIsExactlyWhereASlowHandIs) {
  DrivenProbe probe = probe_at(Vec3::UnitZ(), -1e-3, 1.0);
  const Vec3 hand(1e-4, -2e-4, -0.9e-3);
  hold_probe(probe, hand, kTick);
  EXPECT_EQ(probe.displacement, hand);
  EXPECT_EQ(probe.depth, hand[2]);
  EXPECT_EQ(probe.hand, hand[2]);
}

// 0.5 m/s are half a millimetre a cycle, along the straight way.
TEST(HoldProbe, AHandThatJumpsIsFollowedNoFasterThanStated) {
  DrivenProbe probe = probe_at(Vec3::UnitZ(), 0.0, 1.0);
  hold_probe(probe, {3e-3, 0, 4e-3}, kTick);
  EXPECT_NEAR(probe.displacement[0], 0.3e-3, 1e-15);
  EXPECT_NEAR(probe.displacement[2], 0.4e-3, 1e-15);
  EXPECT_EQ(probe.depth, probe.displacement[2]);
}

TEST(HoldProbe, DepthIsAlongThePress) {
  DrivenProbe probe = probe_at(-Vec3::UnitX(), 0.0, 1.0);
  hold_probe(probe, {-1e-4, 1e-4, 0}, kTick);
  EXPECT_EQ(probe.depth, 1e-4);
}

TEST(HoldProbe, GoesNoDeeperThanTheScene) {
  DrivenProbe probe = probe_at(Vec3::UnitZ(), 0.0, 2e-4);
  hold_probe(probe, {0, 1e-4, 3e-4}, kTick);
  EXPECT_EQ(probe.depth, 2e-4);
  EXPECT_EQ(probe.displacement, Vec3(0, 1e-4, 2e-4));
}

}  // namespace
}  // namespace palpate::devices
