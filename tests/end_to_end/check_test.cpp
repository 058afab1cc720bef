#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/end_to_end/program.hpp"
#include "tests/support/places.hpp"
#include "tests/trials/support/files.hpp"

namespace palpate::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

json printed(const std::vector<std::string>& arguments) {
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return json::parse(outcome.out);
}

// The forces that `check` finds are those that `press` gives at the same depth.
TEST(Check, TellsWhatThereIsToFeel) {
  const std::string protocol = source_folder() + "/protocols/kuroda2003.toml";
  const json check = printed({"check", protocol, "--format", "json"});
  const json pressed = printed({"press", protocol, "--steps", "20", "--format", "json"});
  ASSERT_EQ(check["stimuli"].size(), 2U);
  for (const json& cell : check["stimuli"]) {
    const auto& conditions = cell["conditions"];
    std::vector<double> forces;
    for (const json& stimulus : pressed["stimuli"]) {
      if (stimulus["cell"] != cell["cell"]) continue;
      if (std::ranges::find(conditions, stimulus["condition"]) == conditions.end()) continue;
      for (const json& step : stimulus["curve"])
        if (std::abs(step["depth"].get<double>() - cell["depth"].get<double>()) < 1e-9)
          forces.push_back(step["normal_force"]);
    }
    ASSERT_EQ(forces.size(), 2U);
    EXPECT_THAT(cell["forces"].get<std::vector<double>>(),
                testing::Pointwise(testing::DoubleNear(1e-9), forces));
    EXPECT_NEAR(cell["difference"], std::ranges::max(forces) / std::ranges::min(forces) - 1.0, 1e-9);
  }
  EXPECT_THAT(check["warnings"].get<std::vector<std::string>>(),
              testing::ElementsAre(HasSubstr("in cell sibille nobody can tell soft and hard apart")));
  EXPECT_GT(check["minutes"], 1);
}

/// The line of a file that holds a text, counted from 1.
long line_with(const std::string& file, const std::string& text) {
  const std::string all = trials::test::read(file);
  return std::count(all.begin(), all.begin() + static_cast<long>(all.find(text)), '\n') + 1;
}

TEST(Check, TellsWhichLineCallsForAnEffectAndWhatItCosts) {
  const std::string scene = source_folder() + "/data/scenes/rectal-palpation.toml";
  const std::string at = scene + ":" + std::to_string(line_with(scene, "\nmodel ") + 1);
  const json effects = printed({"check", scene, "--format", "json"})["effects"];
  EXPECT_EQ(effects[0]["effect"], "linear elasticity");
  EXPECT_GT(effects[0]["cycle_us"], 0.0);
  EXPECT_EQ(effects[1]["effect"], "contact");
  EXPECT_TRUE(effects[1]["on"]);
  EXPECT_EQ(effects[1]["called_for_at"], at);
  EXPECT_EQ(effects[1]["key"], "contact.model");
  EXPECT_TRUE(effects[1]["measured"]);
  EXPECT_GT(effects[1]["cycle_us"], 0.0);
  for (std::size_t i = 2; i < effects.size(); ++i) {
    EXPECT_FALSE(effects[i]["on"]);
    EXPECT_TRUE(effects[i]["called_for_at"].is_null());
    EXPECT_FALSE(effects[i]["measured"]);
    EXPECT_EQ(effects[i]["cycle_us"], 0.0);
  }
  EXPECT_THAT(run({"check", scene}).out,
              AllOf(HasSubstr(at + " contact.model = \"kuroda\" between rectum and prostate\n"),
                    HasSubstr("nothing calls for it: no contact.friction\n"),
                    HasSubstr("finger: a point, which holds 1 node; ")));
  EXPECT_THAT(run({"check", scene, "--model", "exact"}).out, HasSubstr("  --set contact.model = \"exact\""));
  EXPECT_THAT(run({"check", scene, "--model", "none"}).out,
              HasSubstr("nothing calls for it: contact.model = \"none\"\n"));
}

/// A shipped protocol that can be read from anywhere.
std::string shipped(const std::string& protocol) {
  return std::regex_replace(trials::test::read(source_folder() + "/protocols/" + protocol),
                            std::regex("\\.\\./data/scenes"), source_folder() + "/data/scenes");
}

// Two contact models are pressed, and what people are to go by is held against their forces.
TEST(Check, TellsTheForcesOfTwoContactModels) {
  const std::string protocol = source_folder() + "/protocols/feel-the-difference.toml";
  const json check = printed({"check", protocol, "--format", "json"});
  EXPECT_TRUE(check["feedback"]);
  EXPECT_TRUE(check["warnings"].empty()) << check["warnings"];
  ASSERT_EQ(check["stimuli"].size(), 2U);
  for (const json& cell : check["stimuli"]) {
    EXPECT_EQ(cell["conditions"], (json{"exact", "cheap"}));
    EXPECT_LT(cell["forces"][0], cell["forces"][1]);
    EXPECT_GT(cell["expected_correct"], 0.75);
  }
  EXPECT_THAT(run({"check", protocol}).out, HasSubstr("\n  feedback        after each answer, for 3 s: "));
  EXPECT_THAT(run({"check", source_folder() + "/protocols/kuroda2003.toml"}).out, Not(HasSubstr("feedback")));
}

TEST(Check, WarnsOfAnAnswerThatTheForcesContradict) {
  const trials::test::TemporaryFolder folder;
  const std::string file = folder / "p.toml";
  trials::test::write(file, std::regex_replace(shipped("feel-the-difference.toml"), std::regex("\"softest\""),
                                               "\"stiffest\""));
  const json check = printed({"check", file, "--format", "json"});
  for (const json& cell : check["stimuli"]) EXPECT_LT(cell["expected_correct"], 0.25);
  EXPECT_THAT(check["warnings"].get<std::vector<std::string>>(),
              testing::Each(
                  HasSubstr("the correct condition is not what is asked for, the stiffest: \"exact\" pushes "
                            "back less than \"cheap\"")));
}

TEST(Check, WarnsOfAQuestionThatAsksForTheOther) {
  const trials::test::TemporaryFolder folder;
  const std::string file = folder / "p.toml";
  trials::test::write(
      file, std::regex_replace(shipped("kuroda2003.toml"), std::regex("feel harder"), "feel softer"));
  EXPECT_THAT(printed({"check", file, "--format", "json"})["warnings"].get<std::vector<std::string>>(),
              Contains(HasSubstr("seems to ask for the softest interval, and correct is \"hard\"")));
}

}  // namespace
}  // namespace palpate::test
