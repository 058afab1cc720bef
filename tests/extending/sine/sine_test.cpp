#include "tests/extending/sine/sine.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "devices/devices.hpp"

namespace palpate::devices {
namespace {

TEST(Sine, GoesInAndOutInItsTime) {
  const OpenDevice hand = open("sine");
  ASSERT_EQ(hand.device, &sine());
  const auto depth_at = [&](double time) {
    return hand.device->read(*hand.handle, {.since_begin = time}).position.z();
  };
  EXPECT_NEAR(depth_at(0.0), 0.0, 1e-15);
  EXPECT_NEAR(depth_at(0.25), 1e-3, 1e-15);
  EXPECT_NEAR(depth_at(0.5), 2e-3, 1e-15);
  EXPECT_NEAR(depth_at(1.0), 0.0, 1e-15);
}

TEST(Sine, IsOneOfTheDevices) {
  EXPECT_THAT([] { open("cosine"); }, testing::ThrowsMessage<std::invalid_argument>(
                                          testing::HasSubstr("mouse, scripted:FILE, sine")));
}

}  // namespace
}  // namespace palpate::devices
