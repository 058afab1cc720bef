#include "devices/scripted/path.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace palpate::devices {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* kNames = "time_s,finger.x_m,finger.y_m,finger.z_m\n";

std::string refusal(const std::string& text) {
  try {
    parse_path(text, "path.csv");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Path, ReadsEachProbesPlaces) {
  const auto paths = parse_path(
      "time_s,finger.x_m,finger.y_m,finger.z_m,thumb.x_m,thumb.y_m,thumb.z_m\n"
      "0,0,0,-1e-3,1,2,3\n"
      "0.5,1e-3,0,2e-3,4,5,6\n",
      "path.csv");
  ASSERT_EQ(paths.size(), 2U);
  EXPECT_EQ(paths[0].probe, "finger");
  EXPECT_EQ(paths[1].probe, "thumb");
  EXPECT_EQ(paths[0].places[1], sim::Vec3(1e-3, 0, 2e-3));
  EXPECT_EQ(paths[1].places[0], sim::Vec3(1, 2, 3));
  EXPECT_EQ(paths[1].times, (std::vector<double>{0, 0.5}));
}

TEST(Path, ReadsRotationsAndColumnsInAnyOrder) {
  const auto paths = parse_path(
      "time_s,a.rz_rad,a.z_m,b.x_m,b.y_m,b.z_m,a.rx_rad,a.ry_rad,a.x_m,a.y_m\n"
      "0,0.3,3,4,5,6,0.1,0.2,1,2\n",
      "path.csv");
  ASSERT_EQ(paths.size(), 2U);
  EXPECT_EQ(paths[0].probe, "a");
  EXPECT_EQ(paths[0].places, (std::vector<sim::Vec3>{{1, 2, 3}}));
  EXPECT_EQ(paths[0].rotations, (std::vector<sim::Vec3>{{0.1, 0.2, 0.3}}));
  EXPECT_EQ(paths[1].places, (std::vector<sim::Vec3>{{4, 5, 6}}));
  EXPECT_TRUE(paths[1].rotations.empty());
}

TEST(Path, IsStraightBetweenSamplesAndStaysAtItsEnds) {
  const ProbePath path = parse_path(std::string(kNames) + "1,0,0,0\n2,0,0,4\n4,2,0,4\n", "path.csv").front();
  EXPECT_EQ(place_at(path, 0.0), sim::Vec3(0, 0, 0));
  EXPECT_EQ(place_at(path, 1.25), sim::Vec3(0, 0, 1));
  EXPECT_EQ(place_at(path, 2.0), sim::Vec3(0, 0, 4));
  EXPECT_EQ(place_at(path, 3.0), sim::Vec3(1, 0, 4));
  EXPECT_EQ(place_at(path, 9.0), sim::Vec3(2, 0, 4));
}

struct Refusal {
  std::string text, says;
};
class RefusedPath : public testing::TestWithParam<Refusal> {};

TEST_P(RefusedPath, SaysFileLineAndWhatIsAccepted) {
  EXPECT_THAT(refusal(GetParam().text), AllOf(HasSubstr("path.csv"), HasSubstr(GetParam().says)));
}

INSTANTIATE_TEST_SUITE_P(
    Texts, RefusedPath,
    testing::Values(
        Refusal{"", ": no samples; a path has the columns time_s and"}, Refusal{kNames, ": no samples"},
        Refusal{"t,finger.x_m,finger.y_m,finger.z_m\n0,0,0,0\n", ":1: the first column is \"t\"; a path has"},
        Refusal{"time_s,finger.x_m,finger.y_m\n0,0,0\n",
                ":1: the column \"finger.z_m\" is missing; a path has"},
        Refusal{"time_s\n0\n", ":1: 1 column; a path has"},
        Refusal{"time_s,finger.x_m,finger.y_m,finger.z_mm\n0,0,0,0\n",
                ":1: column 4 is \"finger.z_mm\"; a path has"},
        Refusal{"time_s,finger.x_m,finger.y_m,thumb.z_m\n0,0,0,0\n",
                ":1: the column \"finger.z_m\" is missing"},
        Refusal{"time_s,.x_m,.y_m,.z_m\n0,0,0,0\n", ":1: column 2 is \".x_m\""},
        Refusal{"time_s,a.x_m,a.y_m,a.z_m,a.x_m,a.y_m,a.z_m\n0,0,0,0,0,0,0\n",
                ":1: the column \"a.x_m\" is there twice"},
        Refusal{"time_s,a.x_m,a.y_m,a.z_m,a.rx_rad,a.rz_rad\n0,0,0,0,0,0\n",
                ":1: the column \"a.ry_rad\" is missing"},
        Refusal{"time_s,a.x_m,a.y_m,a.z_m,speed\n0,0,0,0,0\n", ":1: column 5 is \"speed\"; a path has"},
        Refusal{std::string(kNames) + "0,0,0,0\n0.1,0,0\n", ":3: 3 fields; the first line has 4"},
        Refusal{std::string(kNames) + "0,0,0,5 mm\n", ":2: finger.z_m is \"5 mm\"; a finite number"},
        Refusal{std::string(kNames) + "0,nan,0,0\n", ":2: finger.x_m is \"nan\"; a finite number"},
        Refusal{std::string(kNames) + "0,0,,0\n", ":2: finger.y_m is \"\"; a finite number"},
        Refusal{std::string(kNames) + "0,0,0,0\n0,0,0,0\n", ":3: time_s is 0 after 0; times must ascend"}));

}  // namespace
}  // namespace palpate::devices
