#include "devices/mouse/mouse.hpp"

#include <gtest/gtest.h>

#include "devices/mouse/pseudo_haptic.hpp"

namespace palpate::devices {
namespace {

TEST(Mouse, KnowsNothingUntilThePageTellsAndAgainOnceItForgets) {
  const auto handle = mouse().open("");
  EXPECT_FALSE(mouse().read(*handle, {}).known);
  mouse().tell(*handle, 2e-3, 5);
  const Reading reading = mouse().read(*handle, {.now = 9});
  EXPECT_TRUE(reading.known);
  EXPECT_EQ(reading.measured, 5);
  mouse().tell(*handle, std::nullopt, 6);
  EXPECT_FALSE(mouse().read(*handle, {}).known);
}

TEST(Mouse, ADepthIsAWayAlongThePress) {
  const auto handle = mouse().open("");
  mouse().tell(*handle, 2e-3, 0);
  EXPECT_EQ(mouse().read(*handle, {.press = -Vec3::UnitY()}).position, Vec3(0, -2e-3, 0));
}

// The arithmetic is the coupling's, bit for bit, and goes nowhere but along the press.
TEST(Mouse, MovesTheProbeByTheCouplingAlongThePress) {
  DrivenProbe moved = probe_at(Vec3::UnitZ(), -1e-3, 1.0), along = moved;
  for (int i = 0; i < 500; ++i) {
    const double hand = 1e-5 * i, force = moved.depth > 0 ? 8e3 * moved.depth : 0.0;
    mouse().move(moved, hand * Vec3::UnitZ(), force, 1e-3);
    follow_hand({}, along, hand, force, 1e-3);
    ASSERT_EQ(moved.depth, along.depth);
    ASSERT_EQ(moved.hand, along.hand);
    ASSERT_EQ(moved.displacement, Vec3(0, 0, along.depth));
  }
}

TEST(Mouse, SaysThatItGivesNoForceAndWhatCarriesTheStimulus) {
  EXPECT_FALSE(mouse().facts.gives_force);
  EXPECT_EQ(mouse().deliver, nullptr);
  EXPECT_EQ(mouse().facts.channel, "pointer lag");
}

}  // namespace
}  // namespace palpate::devices
