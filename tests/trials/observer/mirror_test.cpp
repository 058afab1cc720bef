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

/// A shipped protocol's text as a study of few.
std::string of_few(const fs::path& shipped) {
  std::string text =
      test::with(test::read(shipped), "../data/scenes/", (protocols() / "../data/scenes/").string());
  text = std::regex_replace(text, std::regex("planned_examinees = [0-9]+"), "planned_examinees = 3");
  return std::regex_replace(text, std::regex("\\nlooks[^\\n]*|\\nspending[^\\n]*"), "");
}

Protocol loaded(const std::string& text, const fs::path& folder) {
  test::write(folder / "p.toml", text);
  return load_protocol(folder / "p.toml");
}

/// The other one of the pair is correct, and where the file says what is asked for, the opposite is.
std::string mirrored_text(const std::string& text, const Protocol& straight) {
  const std::size_t other =
      straight.presented[0] == straight.correct ? straight.presented[1] : straight.presented[0];
  const std::string correct = std::regex_replace(text, std::regex("(\\ncorrect *= )\"[^\"]*\""),
                                                 "$1\"" + straight.conditions[other].name + "\"");
  const bool stiffest = straight.answer == Answer::Stiffest;
  return std::regex_replace(correct, std::regex("(\\nanswer *= )\"[^\"]*\""),
                            stiffest ? "$1\"softest\"" : "$1\"stiffest\"");
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

// Asked for the softer one of a pair, a person is right as often as asked for the stiffer one. What is mirrored hangs
// on nothing that the person perceives: no answer is right by the name of a condition.
TEST_P(Mirrored, IsAnsweredCorrectlyAsOften) {
  const test::TemporaryFolder folder;
  const fs::path file = protocols() / (GetParam() + ".toml");
  const std::string text = of_few(file);
  const Protocol straight = loaded(text, folder.path());
  const Protocol mirrored = loaded(mirrored_text(text, straight), folder.path());
  ASSERT_TRUE(straight.answer && mirrored.answer);
  ASSERT_NE(straight.answer, mirrored.answer);
  ASSERT_NE(straight.correct, mirrored.correct);
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
    return loaded(test::with(of_few(protocols() / "kuroda2003.toml"), from, to), folder_.path());
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

// No file tells which of two contact models pushes back more: the question says it, or nobody simulated can answer.
TEST_F(AskedFor, IsToBeSaidOfTwoContactModels) {
  const fs::path file = protocols() / "feel-the-difference.toml";
  EXPECT_EQ(load_protocol(file).answer, Answer::Softest);
  const std::string unsaid = std::regex_replace(test::read(file), std::regex("\\nanswer[^\\n]*"), "");
  const Protocol unknown = loaded(
      test::with(unsaid, "../data/scenes/", (protocols() / "../data/scenes/").string()), folder_.path());
  EXPECT_EQ(unknown.answer, std::nullopt);
  EXPECT_THAT([&] { check_observer(unknown, attentive()); },
              testing::ThrowsMessage<std::invalid_argument>(HasSubstr("task.answer: is missing")));
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
