#include "tests/extending/three_interval/three_interval.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "tests/end_to_end/program.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"
#include "trials/observer/observer.hpp"
#include "trials/plan/plan.hpp"
#include "trials/protocol/protocol.hpp"

namespace palpate::tasks {
namespace {

const std::string& example() {
  static const std::string file = test::source_folder() + "/tests/extending/three_interval/example.toml";
  return file;
}

TEST(ThreeInterval, HoldsTheCorrectConditionOnceInAnyInterval) {
  const trials::Protocol protocol = trials::load_protocol(example());
  ASSERT_EQ(protocol.task, &kThreeInterval);
  trials::Generator generator = trials::make_generator(1, "test");
  std::array<int, 3> held{};
  for (int i = 0; i < 300; ++i) {
    const trials::Trial trial = trials::draw_trial(protocol, {}, 1, generator);
    EXPECT_EQ(std::ranges::count(trial.interval_condition, protocol.correct), 1);
    EXPECT_EQ(trial.interval_condition.at(trial.correct_answer - 1), protocol.correct);
    ++held[trial.correct_answer - 1];
  }
  for (const int count : held) EXPECT_NEAR(count, 100, 4 * 8.2);  // four standard deviations of a binomial
}

TEST(ThreeInterval, TheIntervalThatIsAskedForIsAnswered) {
  const trials::ObserverParameters never_lapses{};
  const trials::Observer observer{.parameters = &never_lapses};
  trials::Generator generator = trials::make_generator(1, "test");
  const std::array<std::optional<double>, 3> percepts{0.2, 0.7, -0.1};
  trials::Protocol protocol;
  EXPECT_EQ(kThreeInterval.decide(protocol, percepts, observer, generator), 2);
  protocol.answer = trials::Answer::Softest;
  EXPECT_EQ(kThreeInterval.decide(protocol, percepts, observer, generator), 3);
}

TEST(ThreeInterval, IsPlayedStoredAndVerified) {
  const test::TemporaryFolder folder;
  const std::string study = folder / "study.db";
  const auto played = test::run({"simulate", example(), "--study", study, "--examinees", "2", "--seed", "1"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const auto verified = test::run({"verify", study});
  EXPECT_EQ(verified.exit_code, 0) << verified.out;
  EXPECT_THAT(verified.out, testing::HasSubstr("2 sittings, 12 answers (0 voided), 36 presentations"));
  EXPECT_EQ(test::run({"export", study, "--as", "csv", "--out", folder / "csv"}).exit_code, 0);
}

// A study to start from, and the reference, know a task as soon as it stands in the list.
TEST(ThreeInterval, StandsInANewStudyAndInTheReference) {
  const test::TemporaryFolder folder;
  const std::string study = folder / "mine";
  const test::Outcome made = test::run({"new", study, "--task", "3IFC", "--procedure", "until-wrong"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const trials::Protocol protocol = trials::load_protocol(study + "/protocol.toml");
  EXPECT_EQ(protocol.task, &kThreeInterval);
  EXPECT_EQ(protocol.procedure->name, "until-wrong");
  const std::string reference = test::run({"new", "--reference", "protocol"}).out;
  for (const char* shown : {"`[task]`, `kind = \"3IFC\"`", "`other = \"soft\"`",
                            "`[order]`, `task.kind = \"3IFC\"`", "`[procedure]`, `kind = \"until-wrong\"`"})
    EXPECT_THAT(reference, testing::HasSubstr(shown));
  const std::string scene = test::run({"new", "--reference", "scene"}).out;
  for (const char* shown : {"`softening = 0.2`", "`\"patch\"`: a node and its neighbours", "`\"spring\"`: "})
    EXPECT_THAT(scene, testing::HasSubstr(shown));
}

}  // namespace
}  // namespace palpate::tasks
