#include "trials/protocol/protocol.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "base/files/sha256.hpp"
#include "tests/support/places.hpp"
#include "tests/trials/support/protocols.hpp"

namespace palpate::trials {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// What load_protocol() says to a protocol file of this text.
std::string refusal_of(const std::string& text) {
  const test::TemporaryFolder folder;
  const auto file = folder / "p.toml";
  test::write(file, text);
  const std::string said = test::message_of<std::invalid_argument>([&] { load_protocol(file); });
  return said.rfind(file.string(), 0) == 0 ? "p.toml" + said.substr(file.string().size()) : said;
}

std::string refusal_with(std::string_view from, std::string_view to) {
  return refusal_of(test::with(test::shipped_text(), from, to));
}

TEST(Protocol, TheStudyOf2003IsReadAsItIsWritten) {
  const std::filesystem::path root = palpate::test::source_folder();
  const Protocol protocol = load_protocol(root / "protocols/kuroda2003.toml");
  EXPECT_EQ(protocol.name, "kuroda2003");
  EXPECT_EQ(protocol.sha256, base::sha256_hex(test::read(root / "protocols/kuroda2003.toml")));
  ASSERT_EQ(protocol.conditions.size(), 3U);  // soft and hard, and absent, which no trial presents
  EXPECT_EQ(protocol.conditions[1].name, "hard");
  EXPECT_EQ(protocol.conditions[1].overrides.at(0).key, "bodies.prostate.young_modulus");
  EXPECT_EQ(protocol.correct, 1U);
  ASSERT_EQ(protocol.cells.size(), 2U);
  EXPECT_EQ(protocol.cells[0].name, "kuroda");
  EXPECT_EQ(protocol.cells[1].name, "sibille");
  EXPECT_EQ(trials_per_session(protocol), 8);
  EXPECT_DOUBLE_EQ(protocol.exploration.min_depth, 3e-3);
  EXPECT_DOUBLE_EQ(protocol.exploration.max_time, 10.0);
  EXPECT_EQ(protocol.exploration.most_presses, 5);
  EXPECT_EQ(protocol.planned_examinees, 15);
  EXPECT_EQ(protocol.analysis.between_models, "sign-flip");
  ASSERT_EQ(protocol.files.size(), 3U);  // the scene and two meshes
  EXPECT_EQ(protocol.files[0].sha256,
            base::sha256_hex(test::read(root / "data/scenes/rectal-palpation.toml")));
  EXPECT_EQ(protocol.files[1].sha256, base::sha256_hex(test::read(root / "data/meshes/rectum.msh")));
}

TEST(Protocol, KeysOfLaterVersionsAreToldAsSuch) {
  for (const char* key : {"levels = [1, 2]", "practice = 3", "language = \"de\"", "participants = {}"})
    EXPECT_THAT(refusal_of(std::string(key) + "\n" + test::shipped_text()),
                AllOf(StartsWith("p.toml:1: "), HasSubstr("is not in this version")));
  EXPECT_THAT(refusal_of(test::shipped_text() + "\n[participants]\nleast_age = 18\n"),
              HasSubstr("participants: is not in this version"));
  EXPECT_THAT(refusal_with("trials_per_examinee_per_cell = 4", "levels = [\"1 MPa\"]\ntrials_per_level = 4"),
              HasSubstr("procedure.level"));
  EXPECT_THAT(refusal_with("kind = \"constant\"", "kind = \"questplus\""),
              HasSubstr("found \"questplus\", which is not in this version"));
  EXPECT_THAT(refusal_with("kind = \"constant\"", "kind = \"constant\"\nstart = 3"),
              HasSubstr("procedure.start: is not in this version"));
}

TEST(Protocol, ASceneThatIsNotThereIsToldWithTheLineThatNamesIt) {
  EXPECT_THAT(refusal_with("rectal-palpation.toml", "nowhere.toml"),
              AllOf(StartsWith("p.toml:"), HasSubstr(": scene: "), HasSubstr("nowhere.toml: no such file")));
}

TEST(Protocol, AMeshThatIsNotThereIsToldWithTheLineOfTheSceneThatNamesIt) {
  const test::TemporaryFolder folder;
  test::write(folder / "scene.toml", test::read(std::filesystem::path(palpate::test::source_folder()) /
                                                "data/scenes/rectal-palpation.toml"));
  test::write(folder / "p.toml",
              test::with(test::shipped_text(),
                         std::string(palpate::test::source_folder()) + "/data/scenes/rectal-palpation.toml",
                         "scene.toml"));
  EXPECT_THAT(test::message_of<std::invalid_argument>([&] { load_protocol(folder / "p.toml"); }),
              AllOf(HasSubstr("scene.toml:7: bodies.rectum.mesh: "), HasSubstr("rectum.msh: no such file")));
}

TEST(Protocol, StimuliAreScenesWithCellAndConditionInPlace) {
  const Protocol protocol =
      load_protocol(std::filesystem::path(palpate::test::source_folder()) / "protocols/kuroda2003.toml");
  const auto& stimulus = protocol.stimuli.at(stimulus_index(protocol, 1, 1));
  const sim::Scene scene = sim::load_scene(protocol.scene_file, stimulus.overrides);
  EXPECT_EQ(scene.contact.model, "sibille");
  EXPECT_DOUBLE_EQ(scene.bodies.at(1).material.young_modulus, 5e6);
}

TEST(Protocol, OverridesMayBeAnyValueOfTheScene) {
  for (const auto& [text, value] : std::vector<std::pair<std::string, std::string>>{
           {"present\" = false", "false"},
           {"poisson_ratio\" = 0.25", "0.25"},
           {"offset\" = [\"0 mm\", \"0 mm\", \"1 mm\"]", "[ '0 mm', '0 mm', '1 mm' ]"}}) {
    const test::TemporaryFolder folder;
    test::write(folder / "p.toml", test::with(test::shipped_text(), "young_modulus\" = \"5.0 MPa\"", text));
    EXPECT_EQ(load_protocol(folder / "p.toml").conditions[1].overrides.at(0).value, value);
  }
}

TEST(Protocol, PlanIsToldInWordsAndNumbers) {
  const PlanSummary plan = describe(test::small_protocol(4));
  EXPECT_EQ(plan.trials_per_session, 8);
  EXPECT_EQ(plan.trials_per_cell, 60);  // as in the paper: 15 examinees, four trials
  EXPECT_DOUBLE_EQ(plan.best_guess, 0.5);
  EXPECT_THAT(plan.order, HasSubstr("50 %"));
}

TEST(Protocol, MistypedKeysNameFileLineAndTheKeyThatIsMeant) {
  EXPECT_THAT(refusal_with("alpha          =", "alpah ="),
              AllOf(StartsWith("p.toml:"), HasSubstr("analysis.alpha: is missing")));
  EXPECT_THAT(
      refusal_with("[sample]", "[sample]\nplaned_examinees = 3"),
      AllOf(StartsWith("p.toml:39: sample.planed_examinees: unknown key"), HasSubstr("planned_examinees")));
  EXPECT_THAT(refusal_with("[display]", "colour = 1\n[display]"),
              HasSubstr("exploration.colour: unknown key"));
  EXPECT_THAT(refusal_with("question =", "qestion ="), HasSubstr("question: is missing"));
}

TEST(Protocol, QuantitiesNeedTheRightUnit) {
  EXPECT_THAT(refusal_with("\"3 mm\"", "\"3\""),
              AllOf(StartsWith("p.toml:32: exploration.min_depth"), HasSubstr("mm")));
  EXPECT_THAT(refusal_with("\"3 mm\"", "3"), HasSubstr("accepted: a quantity with its unit"));
  EXPECT_THAT(refusal_with("\"3 mm\"", "\"3 s\""), HasSubstr("exploration.min_depth"));
  EXPECT_THAT(refusal_with("\"10 s\"", "\"10 mm\""), HasSubstr("exploration.max_time"));
}

TEST(Protocol, ImpossiblePlansAreRefused) {
  EXPECT_THAT(refusal_with("[\"soft\", \"hard\"]", "[\"soft\", \"firm\"]"),
              AllOf(HasSubstr("task.pair"), HasSubstr("\"firm\" is no condition"), HasSubstr("soft, hard")));
  EXPECT_THAT(refusal_with("[\"soft\", \"hard\"]", "[\"soft\", \"soft\"]"),
              HasSubstr("two different conditions"));
  EXPECT_THAT(refusal_with("correct = \"hard\"", "correct = \"firm\""), HasSubstr("task.correct"));
  EXPECT_THAT(refusal_with("per_cell = 4", "per_cell = 0"),
              HasSubstr("found 0, accepted: a whole number from 1"));
  EXPECT_THAT(refusal_with("per_cell = 4", "per_cell = -4"), HasSubstr("found -4"));
  EXPECT_THAT(refusal_with("[1, 5]", "[5, 1]"), AllOf(HasSubstr("p.toml:31:"), HasSubstr("found [5, 1]")));
  EXPECT_THAT(refusal_with("[1, 5]", "[1]"), HasSubstr("exploration.presses"));
  EXPECT_THAT(refusal_with("= 0.05", "= 0"), HasSubstr("analysis.alpha: found 0"));
  EXPECT_THAT(refusal_with("= 0.05", "= 1.0"), HasSubstr("analysis.alpha: found 1"));
  EXPECT_THAT(refusal_with("= 0.05", "= nan"), HasSubstr("analysis.alpha"));
  EXPECT_THAT(refusal_with("planned_examinees = 15", "planned_examinees = 0"),
              HasSubstr("sample.planned_examinees"));
  EXPECT_THAT(refusal_with("[\"kuroda\", \"sibille\"]", "[\"kuroda\", \"sibille\", \"none\"]"),
              HasSubstr("between_models: compares two cells"));
}

// Each way of drawing the order has the test that holds for it.
TEST(Protocol, TheOrderAndItsTestMustFit) {
  EXPECT_THAT(refusal_with("\"coin\"", "\"balanced\""),
              AllOf(HasSubstr("analysis.primary"), HasSubstr("holds for coin flips only"),
                    HasSubstr("\"order-randomisation\"")));
  EXPECT_THAT(refusal_with("\"paired-comparison\"", "\"order-randomisation\""),
              AllOf(HasSubstr("analysis.primary"), HasSubstr("is for balanced orders")));
  const std::string balanced = test::with(test::with(test::shipped_text(), "\"coin\"", "\"balanced\""),
                                          "\"paired-comparison\"", "\"order-randomisation\"");
  EXPECT_EQ(parse_protocol(balanced, "p.toml").interval_order, IntervalOrder::Balanced);
  EXPECT_THAT(refusal_of(test::with(balanced, "per_cell = 4", "per_cell = 5")),
              AllOf(HasSubstr("order.interval"), HasSubstr("5 trials of a cell cannot be halved")));
}

TEST(Protocol, FeedbackIsGivenOnlyWhereItIsAskedFor) {
  const auto with_feedback = [](std::string_view value) {
    return test::with(test::shipped_text(), "correct = \"hard\"",
                      "correct = \"hard\"\nfeedback = " + std::string(value));
  };
  EXPECT_FALSE(parse_protocol(test::shipped_text(), "p.toml").feedback);
  EXPECT_FALSE(parse_protocol(with_feedback("false"), "p.toml").feedback);
  const Protocol told = parse_protocol(with_feedback("true"), "p.toml");
  EXPECT_TRUE(told.feedback);
  EXPECT_GE(minutes_of(told), minutes_of(parse_protocol(test::shipped_text(), "p.toml")));
  EXPECT_THAT(describe(told).order,
              HasSubstr("whatever rule is followed and whatever is told of earlier answers"));
  EXPECT_THAT(refusal_of(with_feedback("\"yes\"")), HasSubstr("task.feedback"));
}

// Who is told which answers were right knows how many of a balanced cell's orders are left (guessers_test).
TEST(Protocol, FeedbackOnBalancedOrdersIsRefused) {
  const std::string balanced = test::with(test::with(test::shipped_text(), "\"coin\"", "\"balanced\""),
                                          "\"paired-comparison\"", "\"order-randomisation\"");
  EXPECT_THAT(refusal_of(test::with(balanced, "correct = \"hard\"", "correct = \"hard\"\nfeedback = true")),
              AllOf(StartsWith("p.toml:"), HasSubstr("order.interval: found \"balanced\" with task.feedback"),
                    HasSubstr("accepted: \"coin\", or no feedback")));
}

TEST(Protocol, PlannedLooksAscendToThePlannedSample) {
  const auto with_looks = [](const std::string& looks) {
    return test::with(test::shipped_text(), "alpha          = 0.05", "alpha = 0.05\n" + looks);
  };
  const Protocol protocol =
      parse_protocol(with_looks("looks = [5, 10, 15]\nspending = \"pocock\""), "p.toml");
  EXPECT_EQ(protocol.analysis.looks, (std::vector<int>{5, 10, 15}));
  EXPECT_EQ(protocol.analysis.spending, "pocock");
  EXPECT_THAT(refusal_of(with_looks("looks = [5, 5, 15]")), HasSubstr("accepted: ascending numbers"));
  EXPECT_THAT(refusal_of(with_looks("looks = [5, 16]")), HasSubstr("at most the 15 planned"));
  EXPECT_THAT(refusal_of(with_looks("looks = [5, 10]")), HasSubstr("ends with 10"));
  EXPECT_THAT(refusal_of(with_looks("looks = [15]")), HasSubstr("analysis.spending"));
  EXPECT_THAT(refusal_of(with_looks("looks = [15]\nspending = \"haybittle\"")),
              HasSubstr("obrien-fleming, pocock"));
}

TEST(Protocol, WhatTheSceneDoesNotTakeIsRefusedWithItsLine) {
  EXPECT_THAT(refusal_with("\"sibille\"]", "\"sybille\"]"),
              AllOf(StartsWith("p.toml:15: factors.\"contact.model\""), HasSubstr("sybille")));
  EXPECT_THAT(refusal_with("\"bodies.prostate.young_modulus\" = \"5.0 MPa\"",
                           "\"bodies.prostate.youngs\" = \"5 MPa\""),
              AllOf(StartsWith("p.toml:9: conditions.hard"), HasSubstr("youngs")));
  EXPECT_THAT(refusal_with("\"5.0 MPa\"", "\"5.0 mm\""), HasSubstr("conditions.hard"));
  EXPECT_THAT(refusal_with("\"5.0 MPa\"", "\"-5.0 MPa\""), HasSubstr("conditions.hard"));
  EXPECT_THAT(refusal_with("rectal-palpation.toml", "no-such.toml"), HasSubstr("no-such.toml: no such file"));
}

TEST(Protocol, APlanThatNobodyCanFollowIsRefused) {
  EXPECT_THAT(refusal_with("\"3 mm\"", "\"30 mm\""),
              AllOf(HasSubstr("exploration.min_depth: found 30 mm"), HasSubstr("presses 5 mm deep")));
  EXPECT_THAT(refusal_with("\"10 s\"", "\"1 us\""),
              HasSubstr("exploration.max_time: found \"1 us\", accepted: a quantity >= 0.5 s"));
}

TEST(Protocol, ConditionsAndLevelsThatFeelAlikeAreRefused) {
  EXPECT_THAT(refusal_with("\"bodies.prostate.young_modulus\" = \"5.0 MPa\"", "\"name\" = \"another\""),
              HasSubstr("is the same scene as"));
  EXPECT_THAT(refusal_with("\"5.0 MPa\"", "\"1000 kPa\""),
              HasSubstr("conditions.hard: is the same scene as \"soft\""));
  const std::string same_level =
      test::with(test::shipped_text(), "[\"kuroda\", \"sibille\"]", "[\"kuroda\"]");
  EXPECT_THAT(refusal_of(test::with(same_level, "\"contact.model\" = [\"kuroda\"]",
                                    "\"bodies.rectum.young_modulus\" = [\"1 MPa\", \"1000 kPa\"]")),
              HasSubstr("are the same scene"));
}

TEST(Protocol, WhatTheDesignKnowsButThisVersionDoesNot) {
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"\"2IFC\"", "\"ABX\""}, {"\"constant\"", "\"staircase\""}, {"\"shuffled\"", "\"blocked\""}})
    EXPECT_THAT(refusal_with(from, to), HasSubstr("which is not in this version")) << to;
  EXPECT_THAT(refusal_with("\"2IFC\"", "\"3IFC\""), Not(HasSubstr("not in this version")));
}

TEST(Protocol, FilesThatAreNoProtocolAreRefused) {
  EXPECT_THAT(refusal_of(""), HasSubstr("name: is missing"));
  EXPECT_THAT(refusal_of("name = "), HasSubstr("p.toml:1: no valid TOML"));
  EXPECT_THAT(refusal_of(std::string("\x00\xff\xfe", 3)), HasSubstr("no valid TOML"));
  EXPECT_THAT(refusal_of(test::shipped_text().substr(0, 300)), HasSubstr("p.toml"));
  const std::string folder = std::filesystem::temp_directory_path().string();
  EXPECT_THAT(test::message_of<std::invalid_argument>([&] { load_protocol(folder); }),
              HasSubstr("is a folder"));
  EXPECT_THAT(test::message_of<std::invalid_argument>([] { load_protocol("missing.toml"); }),
              HasSubstr("no such file"));
}

}  // namespace
}  // namespace palpate::trials
