#include "devices/devices.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <stdexcept>

#include "tests/support/temporary_folder.hpp"

namespace palpate::devices {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& wanted) {
  try {
    open(wanted);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

// What the engine, the loop and the session's facts count on, of whatever stands in the list.
TEST(Devices, EachKeepsWhatTheInterfacePromises) {
  std::set<std::string_view> names;
  for (const Device* device : all()) {
    EXPECT_TRUE(names.insert(device->name).second) << device->name;
    EXPECT_FALSE(device->in_words.empty());
    ASSERT_NE(device->open, nullptr);
    ASSERT_NE(device->read, nullptr);
    ASSERT_NE(device->move, nullptr);
    EXPECT_EQ(device->deliver != nullptr, device->facts.gives_force) << device->name;
    EXPECT_EQ(device->facts.continuous_force > 0, device->facts.gives_force);
    EXPECT_GE(device->facts.peak_force, device->facts.continuous_force);
    EXPECT_GT(device->facts.rate, 0);
    const bool pseudo_haptic = device->facts.moved_by_a_person && !device->facts.gives_force;
    EXPECT_EQ(!device->facts.channel.empty(), pseudo_haptic) << device->name;
  }
}

TEST(Devices, OpensByNameAndArgument) {
  EXPECT_EQ(open("mouse").device->name, "mouse");
  const test::TemporaryFolder folder;
  std::ofstream(folder / "a:b.csv") << "time_s,finger.x_m,finger.y_m,finger.z_m\n0,0,0,-0.001\n1,0,0,0.003\n";
  const OpenDevice script = open("scripted:" + (folder / "a:b.csv").string());
  const Reading half = script.device->read(*script.handle, {.now = 7, .since_begin = 0.5});
  EXPECT_TRUE(half.known);
  EXPECT_EQ(half.measured, 7);
  EXPECT_NEAR(half.position[2], 1e-3, 1e-18);
}

TEST(Devices, RefusesWhatItDoesNotKnow) {
  for (const std::string wanted : {"", "rat", "mouse:1", "mouse:", "scripted", "mouse "})
    EXPECT_EQ(refusal(wanted), "\"" + wanted + "\" is no device; accepted: mouse, scripted:FILE");
  EXPECT_THAT(refusal("scripted:/nowhere/path.csv"), HasSubstr("/nowhere/path.csv"));
}

TEST(Devices, AScriptMovesOneProbe) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "two.csv") << "time_s,a.x_m,a.y_m,a.z_m,b.x_m,b.y_m,b.z_m\n0,0,0,0,0,0,0\n";
  EXPECT_THAT(refusal("scripted:" + (folder / "two.csv").string()),
              HasSubstr("2 probes; a scripted hand moves one"));
}

}  // namespace
}  // namespace palpate::devices
