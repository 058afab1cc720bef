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
using testing::Contains;
using testing::HasSubstr;

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

TEST(Check, WarnsOfAQuestionThatAsksForTheOther) {
  const trials::test::TemporaryFolder folder;
  const std::string file = folder / "p.toml";
  std::string text = trials::test::read(source_folder() + "/protocols/kuroda2003.toml");
  text = std::regex_replace(text, std::regex("\\.\\./data/scenes"), source_folder() + "/data/scenes");
  trials::test::write(file, std::regex_replace(text, std::regex("feel harder"), "feel softer"));
  EXPECT_THAT(printed({"check", file, "--format", "json"})["warnings"].get<std::vector<std::string>>(),
              Contains(HasSubstr("seems to ask for the softest interval, and correct is \"hard\"")));
}

}  // namespace
}  // namespace palpate::test
