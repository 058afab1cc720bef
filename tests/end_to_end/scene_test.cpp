// The commands that touch organs, as a user of the program runs them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/end_to_end/program.hpp"
#include "tests/support/places.hpp"
#include "tests/trials/support/files.hpp"

namespace palpate {
namespace {

using nlohmann::json;
using test::Outcome;
using test::run;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using trials::test::read;
using trials::test::TemporaryFolder;
using trials::test::write;

const std::string kSource = palpate::test::source_folder();
const std::string kScene = kSource + "/data/scenes/rectal-palpation.toml";
const std::string kStudy = kSource + "/protocols/kuroda2003.toml";

class SceneCommands : public testing::Test {
 protected:
  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  static json as_json(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--format", "json"});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out, nullptr, false);
  }

  TemporaryFolder folder_;
};

// A stack that overflows is a death without a word.
TEST_F(SceneCommands, AKeyOfThousandsOfPartsIsRefused) {
  std::string key = "a";
  for (int i = 1; i < 40000; ++i) key += ".a";
  for (const std::string& text : {key + " = 1\n", "[" + key + "]\n"}) {
    write(folder_ / "deep.toml", text);
    for (const char* command : {"check", "plan", "press", "cost"}) {
      const Outcome outcome = run({command, file("deep.toml")});
      EXPECT_EQ(outcome.exit_code, 1) << command << outcome.err;
      EXPECT_THAT(outcome.err, HasSubstr("deep.toml:1: a key of more parts than 64")) << command;
    }
  }
  const Outcome outcome = run({"press", kScene, "--set", key + "=1"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("has more parts than 64"));
}

// Table 1 of Kuroda et al. 2003: rectum 282 nodes, 207 of them free; prostate 360 and 110.
TEST_F(SceneCommands, PressGivesTheContractsFields) {
  const json pressed = as_json({"press", kScene, "--depth", "5 mm", "--steps", "2"});
  EXPECT_EQ(pressed["scene"], "rectal palpation");
  EXPECT_EQ(pressed["model"], "kuroda");
  EXPECT_EQ(pressed["units"], json({{"length", "m"}, {"force", "N"}}));
  EXPECT_EQ(pressed["bodies"]["rectum"]["nodes"], 282);
  EXPECT_EQ(pressed["bodies"]["rectum"]["free_surface_nodes"], 207);
  EXPECT_EQ(pressed["bodies"]["prostate"]["nodes"], 360);
  EXPECT_EQ(pressed["bodies"]["prostate"]["free_surface_nodes"], 110);
  ASSERT_EQ(pressed["curve"].size(), 2U);
  const json& last = pressed["curve"][1];
  EXPECT_DOUBLE_EQ(last["depth"], 0.005);
  EXPECT_EQ(last["force"], last["probes"]["finger"]["force"]);
  EXPECT_DOUBLE_EQ(last["normal_force"], -last["force"][2].get<double>());  // the finger presses in +z
  EXPECT_THAT(last["pairs"][0]["bodies"], ElementsAre("rectum", "prostate"));
  EXPECT_GT(last["pairs"][0]["active"], 0);
  EXPECT_LT(last["pairs"][0]["force_on"]["rectum"][2], 0.0);
  EXPECT_GT(last["pairs"][0]["force_on"]["prostate"][2], 0.0);
  EXPECT_EQ(last["solve"]["stop"], "converged");
}

// Fig. 8: with kuroda the harder prostate resists more, and none the least; sibille knows no stiffness.
TEST_F(SceneCommands, APressedProtocolShowsFigure8) {
  const json pressed = as_json({"press", kStudy, "--steps", "4"});
  EXPECT_EQ(pressed["protocol"], "kuroda2003");
  std::map<std::string, double> force;
  for (const json& stimulus : pressed["stimuli"])
    force[stimulus["cell"].get<std::string>() + " " + stimulus["condition"].get<std::string>()] =
        stimulus["curve"].back()["normal_force"];
  ASSERT_EQ(force.size(), 6U);
  EXPECT_LT(1.1 * force.at("kuroda absent"), force.at("kuroda soft"));
  EXPECT_LT(1.1 * force.at("kuroda soft"), force.at("kuroda hard"));
  EXPECT_NEAR(force.at("sibille soft") / force.at("sibille hard"), 1.0, 1e-9);
  EXPECT_EQ(force.at("kuroda absent"), force.at("sibille absent"));
}

TEST_F(SceneCommands, APressedProtocolIsThePressedScene) {
  const json study = as_json({"press", kStudy, "--depth", "4 mm", "--steps", "3"});
  const json scene = as_json({"press", kScene, "--depth", "4 mm", "--steps", "3", "--model", "sibille",
                              "--set", "bodies.prostate.young_modulus=\"5 MPa\""});
  const auto hard = std::ranges::find_if(study["stimuli"], [](const json& stimulus) {
    return stimulus["cell"] == "sibille" && stimulus["condition"] == "hard";
  });
  ASSERT_NE(hard, study["stimuli"].end());
  for (std::size_t step = 0; step < 3; ++step)
    EXPECT_EQ((*hard)["curve"][step]["force"], scene["curve"][step]["force"]);
}

TEST_F(SceneCommands, APressedProtocolsTableHasAColumnForEachStimulus) {
  const Outcome outcome = run({"press", kStudy, "--steps", "2"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(StartsWith("kuroda2003: force [N]"), HasSubstr("soft      hard    absent"),
                                 HasSubstr("\n     2.500 "), HasSubstr("\n     5.000 ")));
}

TEST_F(SceneCommands, PressDrawsAndSaves) {
  const Outcome outcome =
      run({"press", kScene, "--steps", "2", "--plot", file("f.svg"), "--save", file("state")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(read(file("f.svg")), AllOf(HasSubstr("<svg"), HasSubstr("depth [mm]"), HasSubstr("force [N]")));
  const json rectum = as_json({"mesh", file("state.rectum.vtu"), "--unit", "m"});
  EXPECT_EQ(rectum["nodes"], 282);
}

TEST_F(SceneCommands, RenderWritesAPicture) {
  const Outcome outcome =
      run({"render", kScene, "--depth", "5 mm", "--width", "320", "--height", "240", "--out", file("p.png")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(read(file("p.png")), StartsWith("\x89PNG"));
}

TEST_F(SceneCommands, RenderTellsWhatItsColoursMean) {
  const Outcome outcome =
      run({"render", kScene, "--depth", "4 mm", "--color", "displacement", "--cut", "--view", "30,20",
           "--width", "480", "--height", "320", "--out", file("p.png")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("displacement of what is seen 0 to 4 mm"), Not(HasSubstr("warning"))));
  EXPECT_THAT(
      run({"render", kScene, "--depth", "4 mm", "--view", "top", "--cut", "--out", file("p.png")}).err,
      HasSubstr("looks along the press"));
}

TEST_F(SceneCommands, PressAndRenderWarnOfDepthsThatTheSceneIsNotMadeFor) {
  EXPECT_THAT(run({"press", kScene, "--depth", "5 mm"}).err, Not(HasSubstr("warning")));
  const std::string why =
      "warning: probes.finger presses 9 mm deep, deeper than the 5 mm of the scene, and than "
      "rectum is thick under it (4 mm)\n";
  EXPECT_THAT(run({"press", kScene, "--depth", "9 mm"}).err, HasSubstr(why));
  EXPECT_THAT(run({"press", kStudy, "--depth", "9 mm"}).err, HasSubstr(why));
  EXPECT_THAT(run({"render", kScene, "--depth", "9 mm", "--out", file("p.png")}).err, HasSubstr(why));
}

TEST_F(SceneCommands, APlotOfAProtocolHasAPanelForEachCellAndTheDevicesLimit) {
  const Outcome outcome = run({"press", kStudy, "--steps", "2", "--plot", file("f.svg")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(read(file("f.svg")),
              AllOf(HasSubstr(">kuroda<"), HasSubstr(">sibille<"), HasSubstr(">absent<"),
                    HasSubstr("device's limit: 106 N")));  // 8.5 N / 0.08, protocols/observers/default.toml
}

TEST_F(SceneCommands, CheckKnowsScenesProtocolsAndMeshes) {
  EXPECT_THAT(run({"check", kScene}).out, HasSubstr("contact"));
  EXPECT_THAT(run({"check", kStudy}).out, HasSubstr("37 or more correct of 60 in a cell"));
  EXPECT_THAT(run({"check", kSource + "/data/meshes/rectum.msh", "--unit", "m"}).out, HasSubstr("282"));
}

TEST_F(SceneCommands, CheckWarnsOfWhatMisleads) {
  EXPECT_THAT(run({"check", kScene}).out, Not(HasSubstr("warning")));
  EXPECT_THAT(run({"check", kScene, "--set", "bodies.prostate.poisson_ratio=0.49"}).out,
              HasSubstr("warning: poisson_ratio 0.49: linear tetrahedra lock"));
  EXPECT_THAT(run({"check", kScene, "--set", "probes.finger.depth=\"2 m\""}).out,
              HasSubstr("warning: probes.finger presses 2000 mm deep into a body"));
}

// The looks of the sequential study, and its last number, are R's:
//   alpha spent by O'Brien-Fleming's function at 1/3, 2/3, 1 over exact binomial sums; see
//   planned_looks_test.cpp
TEST_F(SceneCommands, CheckAndPlanTellTheSameNumbers) {
  const std::string looks = run({"check", kSource + "/protocols/kuroda2003-sequential.toml"}).out;
  EXPECT_THAT(looks, AllOf(HasSubstr("at 10 examinees: 31 or more"), HasSubstr("at 20 examinees: 51 or more"),
                           HasSubstr("at 30 examinees: 70 or more"), HasSubstr("(size by then 0.0434)")));
  const std::string balanced = run({"check", kSource + "/protocols/kuroda2003-balanced.toml"}).out;
  EXPECT_THAT(balanced, AllOf(HasSubstr("critical value  depends on"), HasSubstr("10000 simulated studies")));
}

TEST_F(SceneCommands, ADirectionIsADirectionHoweverLong) {
  const json once = as_json({"press", kScene, "--steps", "1"});
  const json huge =
      as_json({"press", kScene, "--steps", "1", "--set", "probes.finger.direction=[0,0,1e200]"});
  EXPECT_EQ(once["curve"][0]["force"], huge["curve"][0]["force"]);
}

TEST_F(SceneCommands, AResultThatCannotBeWrittenIsNoSuccess) {
  const std::string command = palpate::test::program_file() + " stats binomial --correct 41 --trials 60 ";
  EXPECT_EQ(WEXITSTATUS(std::system((command + ">/dev/full 2>/dev/null").c_str())), 3);
  EXPECT_EQ(WEXITSTATUS(std::system((command + ">/dev/null").c_str())), 0);
}

// What is wrong, and where: the message names the option, the key or the file.
TEST_F(SceneCommands, SaysWhatIsWrong) {
  write(file("neither.toml"), "a = 1\n");
  const std::vector<std::pair<std::vector<std::string>, std::vector<const char*>>> cases = {
      {{"press", file("none.toml")}, {"none.toml", "no such file"}},
      {{"press", file("neither.toml")}, {"neither.toml", "neither a scene", "nor a protocol"}},
      {{"press", kScene, "--depth", "5 mmm"}, {"--depth", "\"mmm\"", "mm"}},
      {{"press", kScene, "--depth", "0 mm"}, {"--depth 0 mm", "> 0"}},
      {{"render", kScene, "--depth", "-1 mm", "--out", file("p.png")}, {"--depth -1 mm", "0 or more"}},
      {{"render", kScene, "--view", "above", "--out", file("p.png")}, {"--view above", "AZIMUTH,ELEVATION"}},
      {{"render", kScene, "--view", "10,91", "--out", file("p.png")}, {"--view 10,91", "-90 to 90"}},
      {{"render", kScene, "--color", "stress", "--width", "200", "--out", file("p.png")},
       {"--width 200", "374"}},
      {{"press", kScene, "--observer", "o.toml"}, {"--observer o.toml", "with a protocol"}},
      {{"press", kScene, "--plot", file("f.gif")}, {"f.gif", ".svg or .png"}},
      {{"press", kStudy, "--model", "none"}, {"kuroda2003.toml", "--model", "protocol"}},
      {{"press", kStudy, "--save", file("state")}, {"--save", "protocol"}},
      {{"press", kScene, "--set", "bodies.prostate.poisson_ratio=0.5"}, {"poisson_ratio", "0.5"}},
      {{"press", kScene, "--set", "probes.finger.at=[\"1e155 m\",\"0 m\",\"0 m\"]"},
       {"probes.finger: at: is 1e+155 m away from the surface of rectum", "a place at its surface"}},
      {{"press", kScene, "--set", "bodies.prostate.scale=1e160"}, {"bodies.prostate", "from the origin"}},
      {{"press", kScene, "--set", "bodies.prostate.scale=1e-9"}, {"bodies.prostate", "m across"}},
      {{"press", kScene, "--set", "bodies.prostrate.scale=2"},
       {"\"prostrate\" is no body of this scene", "prostate, rectum"}},
      {{"check", "/dev/zero"}, {"/dev/zero", "is a device"}},
      {{"mesh", kSource + "/data/meshes/rectum.msh", "--unit", "mm", "--out",
        kSource + "/data/meshes/rectum.msh"},
       {"--out", "the mesh itself"}},
  };
  for (const auto& [arguments, parts] : cases) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, StartsWith("Error: "));
    for (const char* part : parts) EXPECT_THAT(outcome.err, HasSubstr(part));
  }
  EXPECT_TRUE(std::filesystem::is_regular_file(file("neither.toml")));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1);
}

TEST_F(SceneCommands, WrongUsageNamesTheCommandWhoseHelpTells) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"press"}, {"press", kScene, "--steps", "0"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, AllOf(StartsWith("Error: "), HasSubstr("`palpate press --help`")));
  }
  EXPECT_EQ(run({"prss"}).exit_code, 2);
  EXPECT_THAT(run({"prss"}).err,
              AllOf(StartsWith("Error: "), HasSubstr("prss"), HasSubstr("`palpate --help`")));
}

}  // namespace
}  // namespace palpate
