#include "trials/observer/simulate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/places.hpp"
#include "tests/trials/support/protocols.hpp"
#include "tests/trials/support/sitting.hpp"
#include "tests/trials/support/up_down.hpp"
#include "trials/observer/simulated_study.hpp"
#include "trials/study/verify.hpp"
#include "trials/tables/table.hpp"

namespace palpate::trials {
namespace {

using testing::HasSubstr;

/// Read and compiled once for all tests of this file: the shipped study with two questions a cell.
struct Shared {
  Protocol protocol;
  Stimuli stimuli;

  static const Shared& get() {
    static const Shared shared = [] {
      const test::TemporaryFolder folder;
      test::write(folder / "p.toml", test::with(test::shipped_text(), "per_cell = 4", "per_cell = 2"));
      Shared made{.protocol = load_protocol(folder / "p.toml"), .stimuli = {}};
      sim::ComplianceCache cache("");
      made.stimuli = compile_stimuli(made.protocol, cache);
      return made;
    }();
    return shared;
  }
};

SimulationPlan plan_for(int examinees, Seed seed) {
  SimulationPlan plan{.examinees = examinees,
                      .observer = load_observer(std::filesystem::path(palpate::test::source_folder()) /
                                                "protocols/observers/default.toml"),
                      .seed = seed};
  plan.software_version = "0.1.0";
  plan.machine = "test";
  return plan;
}

class SimulateTest : public testing::Test {
 protected:
  SimulationReport run(const std::string& name, const SimulationPlan& plan, int stop_after = 1000000) {
    const auto& [protocol, stimuli] = Shared::get();
    check_simulation(folder_ / name, protocol, plan);
    StudyFile study = open_study(folder_ / name, protocol, "0.1.0");
    return simulate(study, protocol, stimuli, plan, [&](int done, int) { return done < stop_after; });
  }
  /// Examinee, trial, cell, correct interval and response of every answer.
  std::vector<std::string> answers(const std::string& name) {
    std::vector<std::string> found;
    const StudyFile study = read_study(folder_ / name);
    for (const auto& row : trial_table(study.protocol(), answered_trials(study)).rows)
      found.push_back(std::get<std::string>(row[0]) + " " + std::to_string(std::get<std::int64_t>(row[3])) +
                      " " + std::get<std::string>(row[7]) + " " +
                      std::to_string(std::get<std::int64_t>(row[8])) + " " +
                      std::to_string(std::get<std::int64_t>(row[9])));
    return found;
  }

  test::TemporaryFolder folder_;
};

TEST_F(SimulateTest, OneSeedGivesOneSetOfAnswersAndTraces) {
  run("a.db", plan_for(3, 7));
  run("b.db", plan_for(3, 7));
  EXPECT_EQ(answers("a.db"), answers("b.db"));
  const StudyFile a = read_study(folder_ / "a.db"), b = read_study(folder_ / "b.db");
  const auto shown_a = a.presentations(3), shown_b = b.presentations(3);
  ASSERT_EQ(shown_a.size(), shown_b.size());
  for (std::size_t i = 0; i < shown_a.size(); ++i)
    EXPECT_EQ(shown_a[i].trace_sha256, shown_b[i].trace_sha256);
  run("c.db", plan_for(3, 8));
  EXPECT_NE(answers("a.db"), answers("c.db"));
}

TEST_F(SimulateTest, IsAWholeStudyMarkedAsSimulated) {
  const SimulationReport report = run("a.db", plan_for(3, 7));
  EXPECT_EQ(report.added, 3);
  EXPECT_EQ(report.answers, 12);
  EXPECT_TRUE(verify_study(folder_ / "a.db").problems.empty());
  const StudyFile study = read_study(folder_ / "a.db");
  for (const SessionRow& session : study.sessions()) {
    EXPECT_EQ(session.facts.run_mode, RunMode::Simulated);
    EXPECT_TRUE(session.ended_utc.has_value());
    EXPECT_THAT(session.facts.observer.value_or(""), HasSubstr("\"weber_fraction\""));
  }
  EXPECT_EQ(study.load_trace(study.presentations(1)[0].id).size(), 1000U);
}

TEST_F(SimulateTest, StopsBetweenAnswersAndGoesOn) {
  const SimulationReport stopped = run("a.db", plan_for(4, 7), 6);
  EXPECT_TRUE(stopped.interrupted);
  EXPECT_EQ(stopped.answers, 6);
  EXPECT_EQ(answers("a.db").size(), 6U);
  const SimulationReport rest = run("a.db", plan_for(4, 7));
  EXPECT_EQ(rest.finished_before, 1);
  EXPECT_EQ(rest.answers, 10);
  run("b.db", plan_for(4, 7));
  EXPECT_EQ(answers("a.db"), answers("b.db"));  // nothing had been felt of the trials that came after
  EXPECT_TRUE(verify_study(folder_ / "a.db").problems.empty());
}

TEST_F(SimulateTest, DoesNothingWhenAllHaveFinished) {
  run("a.db", plan_for(2, {}));
  const SimulationReport again = run("a.db", plan_for(2, {}));
  EXPECT_EQ(again.finished_before, 2);
  EXPECT_EQ(again.answers, 0);
}

TEST_F(SimulateTest, RefusesAnotherSeedOrAnotherObserverInOneStudy) {
  run("a.db", plan_for(1, 7));
  const auto refusal = [&](const SimulationPlan& plan) {
    return test::message_of<std::invalid_argument>(
        [&] { check_simulation(folder_ / "a.db", Shared::get().protocol, plan); });
  };
  EXPECT_THAT(refusal(plan_for(2, 8)), HasSubstr("with --seed 7"));
  EXPECT_THAT(refusal(plan_for(2, {})), HasSubstr("with --seed 7"));
  SimulationPlan other = plan_for(2, 7);
  other.observer.lapse_rate = 0.5;
  EXPECT_THAT(refusal(other), HasSubstr("other parameters"));
}

TEST_F(SimulateTest, RefusesCodesThatReadLikeAPersons) {
  const Protocol& protocol = Shared::get().protocol;
  {
    StudyFile study = open_study(folder_ / "a.db", protocol, "0.1.0");
    start_session(study, protocol, test::facts_of("s-2"));
  }
  EXPECT_THAT(test::message_of<std::invalid_argument>(
                  [&] { check_simulation(folder_ / "a.db", protocol, plan_for(3, 7)); }),
              HasSubstr("\"S02\" is not in this study but reads like \"s-2\""));
}

TEST_F(SimulateTest, RefusesACodeThatIsAPersons) {
  const auto& [protocol, stimuli] = Shared::get();
  {
    StudyFile study = open_study(folder_ / "a.db", protocol, "0.1.0");
    start_session(study, protocol, test::facts_of("S02"));
  }
  EXPECT_NO_THROW(check_simulation(folder_ / "a.db", protocol, plan_for(1, 1)));
  EXPECT_THAT(test::message_of<std::invalid_argument>(
                  [&] { check_simulation(folder_ / "a.db", protocol, plan_for(2, 1)); }),
              HasSubstr("examinee S02: is a person in this study"));
}

TEST_F(SimulateTest, OneProgramSimulatesInAStudy) {
  const auto& [protocol, stimuli] = Shared::get();
  StudyFile first = open_study(folder_ / "a.db", protocol, "0.1.0");
  first.lock_for_sessions();
  EXPECT_THAT(test::message_of<std::runtime_error>([&] { run("a.db", plan_for(1, 1)); }),
              HasSubstr("another palpate is leading a session"));
}

TEST_F(SimulateTest, RefusesAnObserverWhoCannotFulfilTheProtocol) {
  SimulationPlan plan = plan_for(1, 7);
  plan.observer.depth.mean = 2e-3;
  EXPECT_THAT(test::message_of<std::invalid_argument>([&] { run("a.db", plan); }),
              HasSubstr("the protocol wants presses of 3 mm"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.db"));
}

TEST(LoadObserver, RefusesWhatItDoesNotKnow) {
  const std::string shipped =
      test::read(std::filesystem::path(palpate::test::source_folder()) / "protocols/observers/default.toml");
  const auto refusal = [&](std::string_view from, std::string_view to) {
    const test::TemporaryFolder folder;
    test::write(folder / "o.toml", test::with(shipped, from, to));
    return test::message_of<std::invalid_argument>([&] { load_observer(folder / "o.toml"); });
  };
  EXPECT_THAT(refusal("\"4.5 mm\"", "\"4.5\""), HasSubstr("press.depth"));
  EXPECT_THAT(refusal("\"4.5 mm\"", "\"-4.5 mm\""),
              HasSubstr("press.depth: found \"-4.5 mm\", accepted: a quantity > 0"));
  EXPECT_THAT(refusal("lapse_rate  ", "lapserate  "), HasSubstr("decision.lapse_rate: is missing"));
  EXPECT_THAT(refusal("= 0.02 ", "= 1.5 "),
              HasSubstr("decision.lapse_rate: found 1.5, accepted: a number from 0 to 1"));
  EXPECT_THAT(refusal("[decision]", "[decision]\nmood = 1"), HasSubstr("decision.mood: unknown key"));
  EXPECT_THAT(refusal("\"8.5 N\"", "\"8.5 mm\""), HasSubstr("device.max_force"));
}

// A study that is played and counted only is the one that would have been stored.
TEST_F(SimulateTest, APlayedStudyIsTheOneThatIsStored) {
  const auto& [shared, stimuli] = Shared::get();
  Protocol protocol = shared;
  protocol.planned_examinees = 3;
  const SimulationPlan plan = plan_for(3, 7);
  run("stored.db", plan);
  const auto counts = play_study(protocol, stimuli, plan.observer, 7);
  const StudyFile study = read_study(folder_ / "stored.db");
  for (const SessionRow& session : study.sessions()) {
    std::vector<SittingCount> stored(protocol.cells.size());
    const auto drawn = study.trials(session.id);
    for (const AnswerRow& answer : study.answers(session.id)) {
      const Trial& trial = drawn.at(answer.trial - 1).trial;
      SittingCount& cell = stored[trial.cell];
      ++cell.trials;
      cell.correct_first += trial.correct_answer == 1 ? 1 : 0;
      cell.answers_first += answer.response == 1 ? 1 : 0;
      cell.correct += answer.correct ? 1 : 0;
    }
    for (std::size_t cell = 0; cell < stored.size(); ++cell) {
      const SittingCount& played = counts[cell][session.id - 1];
      EXPECT_EQ(played.trials, stored[cell].trials);
      EXPECT_EQ(played.correct_first, stored[cell].correct_first);
      EXPECT_EQ(played.answers_first, stored[cell].answers_first);
      EXPECT_EQ(played.correct, stored[cell].correct);
    }
  }
}

// With a procedure that chooses the next trial by the answers, stored and played only are one study as well.
TEST_F(SimulateTest, AnAdaptiveStudyIsAskedToItsEnd) {
  const auto& [shared, stimuli] = Shared::get();
  Protocol protocol = shared;
  protocol.procedure = &test::kUpDown;
  protocol.planned_examinees = 2;
  const SimulationPlan plan = plan_for(2, 7);
  StudyFile study = open_study(folder_ / "adaptive.db", protocol, "0.1.0");
  const SimulationReport report = simulate(study, protocol, stimuli, plan, [](int, int) { return true; });
  EXPECT_EQ(report.answers, 2 * static_cast<int>(test::kUpDownTrials));
  EXPECT_FALSE(report.interrupted);
  const auto counts = play_study(protocol, stimuli, plan.observer, 7);
  for (const SessionRow& session : study.sessions()) {
    EXPECT_TRUE(session.ended_utc.has_value());
    const auto drawn = study.trials(session.id);
    std::vector<int> stored(protocol.cells.size()), correct(protocol.cells.size());
    for (const AnswerRow& answer : study.answers(session.id)) {
      const std::size_t cell = drawn.at(answer.trial - 1).trial.cell;
      ++stored[cell];
      correct[cell] += answer.correct ? 1 : 0;
    }
    for (std::size_t cell = 0; cell < stored.size(); ++cell) {
      EXPECT_EQ(counts[cell][session.id - 1].trials, stored[cell]);
      EXPECT_EQ(counts[cell][session.id - 1].correct, correct[cell]);
    }
  }
}

TEST(SeedOfStudy, DiffersFromStudyToStudyAndSeedToSeed) {
  EXPECT_EQ(seed_of_study(1, 0), seed_of_study(1, 0));
  EXPECT_NE(seed_of_study(1, 0), seed_of_study(1, 1));
  EXPECT_NE(seed_of_study(1, 0), seed_of_study(2, 0));
}

}  // namespace
}  // namespace palpate::trials
