// `palpate press SCENE --path FILE.csv`, as a user runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/end_to_end/program.hpp"
#include "tests/support/places.hpp"
#include "tests/trials/support/files.hpp"

namespace palpate::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string kPressedScene = source_folder() + "/data/scenes/rectal-palpation.toml";
const std::string kColumns = "time_s,finger.x_m,finger.y_m,finger.z_m\n";

class PressPath : public testing::Test {
 protected:
  Outcome along(const std::string& path, std::vector<std::string> more = {}) {
    trials::test::write(folder_ / "path.csv", path);
    std::vector<std::string> arguments{"press", kPressedScene, "--path", (folder_ / "path.csv").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  TemporaryFolder folder_;
};

TEST_F(PressPath, GivesTheContractsFieldsForEachRow) {
  const Outcome outcome =
      along(kColumns + "0.5,0,0,2.5e-3\n0.7,1e-3,-1e-3,5e-3\n", {"--format", "json", "--model", "exact"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json stroke = json::parse(outcome.out);
  EXPECT_EQ(stroke["model"], "exact");
  ASSERT_EQ(stroke["curve"].size(), 2U);
  const json& last = stroke["curve"][1];
  EXPECT_EQ(last["time"], 0.7);
  EXPECT_EQ(last["depth"], 5e-3);
  EXPECT_THAT(last["probes"]["finger"]["displacement"], ElementsAre(1e-3, -1e-3, 5e-3));
  EXPECT_EQ(last["probes"]["finger"]["force"], last["force"]);
  EXPECT_EQ(last["normal_force"].get<double>(), -last["force"][2].get<double>());  // it presses in +z
  EXPECT_EQ(last["solve"]["stop"], "converged");
  EXPECT_EQ(last["pairs"][0]["bodies"], json({"rectum", "prostate"}));

  const Outcome press = run({"press", kPressedScene, "--steps", "2", "--model", "exact", "--format", "json"});
  EXPECT_EQ(stroke["curve"][0]["force"], json::parse(press.out)["curve"][0]["force"]);
}

TEST_F(PressPath, PrintsDrawsAndSaves) {
  const Outcome outcome =
      along(kColumns + "0,0,0,0\n0.25,0,0,4e-3\n",
            {"--plot", (folder_ / "f.svg").string(), "--save", (folder_ / "end").string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(StartsWith("rectal palpation, contact model kuroda\n"),
                                 HasSubstr("time [s]      displacement x y z [mm]"),
                                 HasSubstr("\n      0.25      0.000    0.000    4.000 ")));
  EXPECT_THAT(outcome.out, Not(HasSubstr("-0.0000")));
  EXPECT_THAT(trials::test::read(folder_ / "f.svg"),
              AllOf(HasSubstr("time [s]"), HasSubstr(">normal<"), HasSubstr(">finger<")));
  EXPECT_THAT(trials::test::read(folder_ / "end.prostate.vtu"), HasSubstr("von_mises"));
}

TEST_F(PressPath, WarnsOfWhatTheSceneIsNotMadeForWhereItIsDeepest) {
  EXPECT_THAT(
      along(kColumns + "0,0,0,9e-3\n1,0,0,1e-3\n").err,
      HasSubstr("warning: probes.finger presses 9 mm deep, deeper than the 5 mm of the scene, and than "
                "rectum is thick under it (4 mm)\n"));
  EXPECT_THAT(along(kColumns + "0,0,0,1e-3\n").err, Not(HasSubstr("warning")));
}

TEST_F(PressPath, SaysWhatIsWrongWithTheFile) {
  const std::vector<std::pair<std::string, std::vector<const char*>>> cases = {
      {"time_s,thumb.x_m,thumb.y_m,thumb.z_m\n0,0,0,0\n",
       {"path.csv:1: thumb.x_m: \"thumb\" is no probe of this scene; accepted: finger"}},
      {"time_s,finger.x_m,finger.y_m,finger.z_m,finger.rx_rad,finger.ry_rad,finger.rz_rad\n0,0,0,0,0,0,0\n",
       {"path.csv:1: finger.rx_rad: probes of kind point do not turn; accepted: the file without"}},
      {kColumns + "0,0,0,inf\n", {"path.csv:2: finger.z_m is \"inf\"; a finite number is accepted"}},
      {kColumns + "0,0,0,0\n0,0,0,0\n", {"path.csv:3: time_s is 0 after 0; times must ascend"}},
      {kColumns, {"path.csv: no samples; a path has the columns"}},
  };
  for (const auto& [path, parts] : cases) {
    const Outcome outcome = along(path);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, StartsWith("Error: "));
    for (const char* part : parts) EXPECT_THAT(outcome.err, HasSubstr(part));
  }
}

TEST_F(PressPath, IsInPlaceOfDepthAndStepsAndForAScene) {
  EXPECT_EQ(along(kColumns + "0,0,0,0\n", {"--depth", "5 mm"}).exit_code, 2);
  EXPECT_EQ(along(kColumns + "0,0,0,0\n", {"--steps", "5"}).exit_code, 2);
  const Outcome outcome = run({"press", source_folder() + "/protocols/kuroda2003.toml", "--path", "p.csv"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("--path p.csv"), HasSubstr("is a protocol; accepted: with a scene")));
}

}  // namespace
}  // namespace palpate::test
