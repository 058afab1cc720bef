#include "app/loop/interval_engine.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "app/web/pages/examinee/messages.hpp"
#include "devices/mouse/mouse.hpp"
#include "tests/app/support/palpation.hpp"

namespace palpate::app {
namespace {

using test::palpation;

const devices::Device& kMouse = devices::mouse();
const IntervalLimits kLimits{.least_presses = 1, .most_presses = 3, .min_depth = 1e-3, .max_time = 3.0};

/// The hand at a depth; the scene presses along z.
HandInput at(double depth, double age = 0.0) {
  return {.position = depth * sim::Vec3::UnitZ(), .age = age, .known = true};
}

/// Two presses of a second each, from above the skin.
double scripted_hand(int tick) {
  return 5e-3 - 6e-3 * std::cos(2 * std::numbers::pi * tick * kCycleSeconds);
}

IntervalEngine& drive(IntervalEngine& engine, int ticks) {
  for (int i = 0; i < ticks; ++i) engine.tick(at(scripted_hand(i)));
  return engine;
}

/// Everything that a page would be sent for the scripted path.
std::string messages(const sim::Model& model) {
  IntervalEngine engine(model, kLimits, kMouse);
  std::string bytes;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    engine.tick(at(scripted_hand(static_cast<int>(i))));
    if (i % 16 == 0) bytes += encode_probe(engine.state(), i / 16);
  }
  return bytes;
}

// The geometrical model gives the finger the same force whatever the prostate is made of: not one byte of
// what the page hears may differ.
TEST(IntervalEngine, UnderSibilleSoftAndHardSendTheSameBytes) {
  const std::string soft = messages(palpation("sibille", "1.0 MPa"));
  EXPECT_EQ(soft, messages(palpation("sibille", "5.0 MPa")));
  EXPECT_EQ(soft.size(), 12U * 188U);
}

// Byte 1 tells what follows from the hand: whether it has begun, been deep enough, used up its presses.
TEST(IntervalEngine, UnderKurodaTheMessagesDifferInThePointersPlaceOnly) {
  const std::string soft = messages(palpation("kuroda", "1.0 MPa"));
  const std::string hard = messages(palpation("kuroda", "5.0 MPa"));
  ASSERT_EQ(soft.size(), hard.size());
  EXPECT_NE(soft, hard);  // else there were nothing to answer by
  for (std::size_t i = 0; i < soft.size(); ++i)
    if (i % 12 < 8 && i % 12 != 1)
      EXPECT_EQ(soft[i], hard[i]) << "byte " << i % 12 << " of message " << i / 12;
}

TEST(IntervalEngine, TheSamePathGivesTheSameTrace) {
  const sim::Model model = palpation("kuroda", "5.0 MPa");
  IntervalEngine first(model, kLimits, kMouse), second(model, kLimits, kMouse);
  EXPECT_EQ(drive(first, 2000).trace(), drive(second, 2000).trace());
}

// A press that stops at the first pivot of each cycle must show in the record; one that solves to the end has
// the bound of its rounding alone.
TEST(IntervalEngine, RecordsHowExactlyTheForceWasComputed) {
  sim::Model model = palpation("exact", "1.0 MPa");
  IntervalEngine to_the_end(model, kLimits, kMouse);
  drive(to_the_end, 1000);
  EXPECT_EQ(to_the_end.solve_record().cycles_within_tolerance, 0);
  EXPECT_EQ(to_the_end.solve_record().cycles_at_cap, 0);
  EXPECT_LT(to_the_end.solve_record().force_error_bound, 1e-6);
  model.contact_tolerance = 0.2;
  IntervalEngine early(model, kLimits, kMouse);
  double largest = 0.0;
  for (int i = 0; i < 1000; ++i) {
    early.tick(at(scripted_hand(i)));
    largest = std::max(largest, early.state().force);
  }
  EXPECT_GT(early.solve_record().cycles_within_tolerance, 0);
  EXPECT_GT(early.solve_record().force_error_bound, 1e-6);
  EXPECT_LE(early.solve_record().force_error_bound,
            0.2 * largest * 1.5);  // of |f|, of which this is one part
}

TEST(IntervalEngine, TheTraceHoldsHandAndProbeAndMeetsTheSessionsRule) {
  const sim::Model model = palpation("kuroda", "1.0 MPa");
  IntervalEngine engine(model, kLimits, kMouse);
  drive(engine, 2000);
  const trials::ExplorationSummary summary = trials::summarise(engine.trace());
  EXPECT_EQ(summary.presses, 2);
  EXPECT_EQ(engine.state().presses, 2);
  EXPECT_TRUE(engine.state().may_finish);
  const trials::Exploration rule{.least_presses = 1, .most_presses = 3, .min_depth = 1e-3, .max_time = 3.0};
  EXPECT_EQ(trials::judge(summary, rule), trials::Verdict::Enough);
  for (const trials::TraceSample& sample : engine.trace())
    if (sample.force[2] != 0) ASSERT_GT(sample.depth, 0);
  const trials::TraceSample& deep = engine.trace().at(500);
  EXPECT_GT(deep.proposed_depth, deep.depth);  // the probe lags behind the hand
}

TEST(IntervalEngine, BeginsOnlyOnceTheHandIsOffTheSkin) {
  const sim::Model model = palpation("kuroda", "1.0 MPa");
  IntervalEngine engine(model, kLimits, kMouse);
  for (int i = 0; i < 100; ++i) engine.tick(at(9e-3));
  EXPECT_FALSE(engine.state().begun);
  EXPECT_TRUE(engine.trace().empty());
  EXPECT_LE(engine.state().depth, 0);
  engine.tick(at(0.0));
  EXPECT_TRUE(engine.state().begun);
  EXPECT_EQ(engine.trace().size(), 1U);
}

TEST(IntervalEngine, EndsWhenTheTimeIsUsedUp) {
  const sim::Model model = palpation("kuroda", "1.0 MPa");
  IntervalEngine engine(model, {.least_presses = 1, .most_presses = 50, .min_depth = 1e-3, .max_time = 0.5},
                        kMouse);
  drive(engine, 499);
  EXPECT_FALSE(engine.state().over);
  drive(engine, 10);
  EXPECT_TRUE(engine.state().over);
  EXPECT_EQ(engine.trace().size(), 500U);
}

TEST(IntervalEngine, EndsWhenTheLastPressIsLetGo) {
  const sim::Model model = palpation("kuroda", "1.0 MPa");
  IntervalEngine engine(model, {.least_presses = 1, .most_presses = 1, .min_depth = 1e-3, .max_time = 3.0},
                        kMouse);
  drive(engine, 500);
  EXPECT_FALSE(engine.state().over);  // still pressing
  for (int i = 500; i < 1200; ++i) engine.tick(at(scripted_hand(i)));
  EXPECT_TRUE(engine.state().over);
  EXPECT_EQ(trials::summarise(engine.trace()).presses, 1);
}

class BadHand : public testing::TestWithParam<double> {};

TEST_P(BadHand, EndsInAFaultWithTheForceGoneWithin20Milliseconds) {
  const sim::Model model = palpation("kuroda", "5.0 MPa");
  IntervalEngine engine(model, kLimits, kMouse);
  drive(engine, 500);
  double before = engine.state().force;
  ASSERT_GT(before, 0);
  engine.tick(at(GetParam()));
  for (int i = 0; i < 20; ++i) {
    EXPECT_LE(engine.state().force, before);
    before = engine.state().force;
    engine.tick(at(5e-3));
  }
  EXPECT_EQ(engine.state().force, 0.0);
  EXPECT_EQ(engine.state().fault, Fault::NotFinite);
  drive(engine, 300);
  EXPECT_EQ(engine.state().force, 0.0);  // latched
  EXPECT_TRUE(std::isfinite(engine.state().depth));
}

INSTANTIATE_TEST_SUITE_P(Inputs, BadHand,
                         testing::Values(std::numeric_limits<double>::quiet_NaN(),
                                         std::numeric_limits<double>::infinity(), 1e30));

// The hand is pressing, nothing is heard of it for half a second, and then it is somewhere else.
TEST(IntervalEngine, AGapInTheInputIsNoKick) {
  const sim::Model model = palpation("kuroda", "5.0 MPa");
  IntervalEngine engine(model, kLimits, kMouse);
  drive(engine, 500);
  const double held = scripted_hand(500);
  for (int i = 0; i < 300; ++i) engine.tick(at(held));  // until the probe rests
  const double peak = engine.state().force;
  double before = engine.state().depth;
  const auto check = [&] {
    EXPECT_LE(std::abs(engine.state().depth - before), 0.5e-3);  // the largest speed of the hand
    EXPECT_LE(engine.state().force, 1.05 * peak);                // the probe still comes after the hand
    before = engine.state().depth;
  };
  for (int i = 1; i <= 500; ++i) {
    engine.tick(at(held, i * kCycleSeconds));
    check();
  }
  EXPECT_LE(engine.state().depth, 0);
  EXPECT_EQ(engine.state().force, 0.0);
  for (int i = 0; i < 200; ++i) {
    engine.tick(at(held));
    check();
  }
  EXPECT_EQ(engine.state().fault, Fault::None);
}

// Hard case 43: 500 ms during which nothing ran. What comes then is one cycle's way, and no kick.
TEST(IntervalEngine, ALoopThatWasLateCatchesUpWithNothing) {
  const sim::Model model = palpation("kuroda", "1.0 MPa");
  IntervalEngine late(model, kLimits, kMouse), punctual(model, kLimits, kMouse);
  for (IntervalEngine* engine : {&late, &punctual})
    for (int i = 0; i < 100; ++i) engine->tick(at(-1e-3));
  late.tick(at(8e-3), 500);
  punctual.tick(at(8e-3));
  EXPECT_EQ(late.state().depth, punctual.state().depth);
  EXPECT_EQ(late.state().force, punctual.state().force);
}

// The compliance is taken away under the model: no displacement can be prescribed any more.
TEST(IntervalEngine, ACycleThatCannotBeSolvedIsAFaultAndNoForce) {
  sim::Model model = palpation("kuroda", "1.0 MPa");
  IntervalEngine engine(model, kLimits, kMouse);
  engine.tick(at(-1e-3));
  sim::Compliance nothing = *model.bodies.front().compliance;
  nothing.touch_touch.setZero();
  model.bodies.front().compliance = std::make_shared<const sim::Compliance>(nothing);
  for (sim::Probe& probe : model.probes) probe.compliance.setZero();
  for (int i = 0; i < 100; ++i) {
    engine.tick(at(3e-3));
    EXPECT_EQ(engine.state().force, 0.0);
  }
  EXPECT_EQ(engine.state().fault, Fault::NotFinite);
}

TEST(IntervalEngine, MissedCyclesCountAsTime) {
  const sim::Model model = palpation("kuroda", "1.0 MPa");
  IntervalEngine engine(model, kLimits, kMouse);
  engine.tick(at(-1e-3));
  engine.tick(at(-1e-3), 5);
  EXPECT_EQ(engine.state().tick, 6U);
  engine.tick(at(-1e-3));
  EXPECT_FLOAT_EQ(engine.trace().back().time, 0.006F);
}

// What the screen is given and what the hand felt are one solution: solving the pose once more gives its bits.
TEST(IntervalEngine, HandsOverTheLoadsThatTheHandFelt) {
  const sim::Model model = palpation("kuroda", "5.0 MPa");
  IntervalEngine engine(model, kLimits, kMouse);
  sim::Simulation judge(model);
  int loaded = 0;
  for (int i = 0; i < 1000; ++i) {
    engine.felt().ask();
    engine.tick(at(scripted_hand(i)));
    const FeltCycle* felt = engine.felt().answer();
    ASSERT_NE(felt, nullptr);
    judge.step(felt->probes, kCycleSeconds);
    for (std::size_t body = 0; body < model.bodies.size(); ++body)
      ASSERT_EQ(felt->loads.on_body[body], judge.loads().on_body[body]) << "cycle " << i;
    if (!engine.trace().empty()) {
      EXPECT_EQ(static_cast<float>(felt->probes[0].from_rest[2]), engine.trace().back().displacement[2]);
    }
    loaded += felt->loads.on_body[1].squaredNorm() > 0;
  }
  EXPECT_GT(loaded, 100);  // the organ behind was pressed as well
}

/// A device that pushes back with up to 3 N: the probe is where the hand is.
const devices::Device kArm{.name = "arm",
                           .facts = {.gives_force = true, .continuous_force = 3.0},
                           .move = [](devices::DrivenProbe& probe, const sim::Vec3& target, double,
                                      double step) { devices::hold_probe(probe, target, step); }};

TEST(IntervalEngine, AHandInSpaceMovesTheProbeSidewaysAndFeelsNoMoreThanItsDeviceCanHold) {
  const sim::Model model = palpation("none", "1.0 MPa");
  IntervalEngine engine(model, kLimits, kArm);
  engine.tick(at(-1e-3));
  const sim::Vec3 place(1e-3, -0.5e-3, 2.5e-3);
  for (int i = 0; i < 100; ++i) engine.tick({.position = place, .known = true});
  engine.felt().ask();
  engine.tick({.position = place, .known = true});
  ASSERT_NE(engine.felt().answer(), nullptr);
  EXPECT_EQ(engine.felt().answer()->probes.front().from_rest, place);
  EXPECT_EQ(engine.state().depth, place[2]);

  sim::Simulation judge(model);
  const sim::Vec3 felt = judge.step(engine.felt().answer()->probes, kCycleSeconds).probe_forces.front();
  ASSERT_GT(felt.norm(), 3.0);
  EXPECT_NEAR(engine.force_on_hand().norm(), 3.0, 1e-12);
  EXPECT_NEAR(engine.force_on_hand().normalized().dot(felt.normalized()), 1.0, 1e-12);
  EXPECT_LT(engine.force_on_hand()[0], 0);  // against the way sideways as well
  EXPECT_EQ(engine.trace().back().force[2], static_cast<float>(engine.force_on_hand()[2]));  // as clamped
}

}  // namespace
}  // namespace palpate::app
