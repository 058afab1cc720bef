#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <stdexcept>

#include "sim/compliance/cache.hpp"
#include "tests/trials/support/protocols.hpp"
#include "trials/observer/simulate.hpp"
#include "trials/observer/simulated_study.hpp"
#include "trials/protocol/stimuli.hpp"

namespace palpate::trials {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

fs::path protocols() {
  return fs::path(palpate::test::source_folder()) / "protocols";
}

/// A shipped protocol as a study of few, `from` replaced.
Protocol altered(const fs::path& shipped, const fs::path& folder, std::string_view from,
                 std::string_view to) {
  std::string text =
      test::with(test::read(shipped), "../data/scenes/", (protocols() / "../data/scenes/").string());
  text = std::regex_replace(text, std::regex("planned_examinees = [0-9]+"), "planned_examinees = 3");
  text = std::regex_replace(text, std::regex("\\nlooks[^\\n]*|\\nspending[^\\n]*"), "");
  test::write(folder / "p.toml", from.empty() ? text : test::with(text, from, to));
  return load_protocol(folder / "p.toml");
}

/// An examinee who answers by nothing but what was felt.
ObserverParameters attentive() {
  ObserverParameters observer = load_observer(protocols() / "observers/default.toml");
  observer.lapse_rate = 0.0;
  observer.interval_bias = {};
  return observer;
}

std::vector<std::string> shipped() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(protocols()))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem());
  return names;
}

class Mirrored : public testing::TestWithParam<std::string> {};

// Asked for the softer one of a pair, a person is right as often as asked for the stiffer one.
TEST_P(Mirrored, IsAnsweredCorrectlyAsOften) {
  const test::TemporaryFolder folder;
  const fs::path file = protocols() / (GetParam() + ".toml");
  const Protocol straight = altered(file, folder.path(), "", "");
  const Protocol mirrored = altered(file, folder.path(), "correct = \"hard\"", "correct = \"soft\"");
  ASSERT_EQ(straight.answer, Answer::Stiffest);
  ASSERT_EQ(mirrored.answer, Answer::Softest);
  sim::ComplianceCache cache("");
  const Stimuli stimuli = compile_stimuli(straight, cache);
  const auto one = play_study(straight, stimuli, attentive(), 1);
  const auto other = play_study(mirrored, stimuli, attentive(), 1);
  for (std::size_t cell = 0; cell < one.size(); ++cell)
    for (std::size_t examinee = 0; examinee < one[cell].size(); ++examinee)
      EXPECT_EQ(one[cell][examinee].correct, other[cell][examinee].correct) << straight.cells[cell].name;
}

INSTANTIATE_TEST_SUITE_P(Protocols, Mirrored, testing::ValuesIn(shipped()), [](const auto& name) {
  return std::regex_replace(name.param, std::regex("-"), "_");
});

/// What load_protocol() makes of the first shipped protocol with its answer and conditions changed.
class AskedFor : public testing::Test {
 protected:
  Protocol with(std::string_view from, std::string_view to) {
    return altered(protocols() / "kuroda2003.toml", folder_.path(), from, to);
  }
  test::TemporaryFolder folder_;
};

TEST_F(AskedFor, IsWhatMakesTheCorrectConditionCorrect) {
  EXPECT_EQ(with("correct = \"hard\"", "correct = \"hard\"\nanswer = \"stiffest\"").answer, Answer::Stiffest);
  EXPECT_THAT(
      [&] { with("correct = \"hard\"", "correct = \"hard\"\nanswer = \"softest\""); },
      testing::ThrowsMessage<std::invalid_argument>(HasSubstr(
          "task.answer: found \"softest\", but the correct condition, \"hard\", is the stiffest; accepted")));
  EXPECT_THAT([&] { with("correct = \"hard\"", "correct = \"hard\"\nanswer = \"smoothest\""); },
              testing::ThrowsMessage<std::invalid_argument>(
                  HasSubstr("found \"smoothest\", which is not in this version")));
}

TEST_F(AskedFor, FollowsFromABodyThatIsAbsent) {
  EXPECT_EQ(with("[\"soft\", \"hard\"]", "[\"absent\", \"hard\"]").answer, Answer::Stiffest);
}

TEST_F(AskedFor, IsToBeSaidWhereTheConditionsDoNotTell) {
  const std::string harder = "\"bodies.prostate.young_modulus\" = \"5.0 MPa\"";
  const std::string softer_wall = harder + "\n\"bodies.rectum.young_modulus\" = \"0.5 MPa\"";
  const Protocol unknown = with(harder, softer_wall);
  EXPECT_EQ(unknown.answer, std::nullopt);
  EXPECT_THAT([&] { check_observer(unknown, attentive()); },
              testing::ThrowsMessage<std::invalid_argument>(
                  HasSubstr("task.answer: is missing, and the conditions do not tell")));
}

}  // namespace
}  // namespace palpate::trials
