#include "trials/observer/observer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include "tests/trials/support/observers.hpp"
#include "tests/trials/support/protocols.hpp"
#include "trials/observer/simulate.hpp"

namespace palpate::trials {
namespace {

TEST(Observer, EveryPressGoesAnotherWay) {
  ObserverParameters p = test::plain_observer();
  p.depth.within = 2e-4;
  p.tremor = 5e-5;
  p.drift = 1e-4;
  Generator generator = make_generator(1, "hand");
  const Observer observer = draw_observer(p, generator);
  std::set<double> depths;
  constexpr int kPresses = 400;
  double sum = 0;
  for (int i = 0; i < kPresses; ++i) {
    const auto path = plan_press(observer, sim::Vec3::UnitZ(), generator);
    ASSERT_EQ(path.size(), 1000U);
    EXPECT_EQ(path.front(), sim::Vec3(sim::Vec3::Zero()));
    depths.insert(path.back().z());
    sum += path.back().z();
  }
  EXPECT_EQ(depths.size(), kPresses);
  EXPECT_NEAR(sum / kPresses, 4e-3, 5 * std::hypot(2e-4, 5e-5) / std::sqrt(kPresses));
}

// Without tremor and drift the way in is d (10 t^3 - 15 t^4 + 6 t^5): half the depth at half the time.
TEST(Observer, TheWayInHasTheLeastJerk) {
  Generator generator = make_generator(1, "hand");
  const ObserverParameters p = test::plain_observer();
  const Observer observer = draw_observer(p, generator);
  const auto path = plan_press(observer, sim::Vec3::UnitX(), generator);
  EXPECT_NEAR(path[300].x(), 2e-3, 1e-12);
  EXPECT_NEAR(path[150].x(), 4e-3 * (10.0 / 64 - 15.0 / 256 + 6.0 / 1024), 1e-12);
  EXPECT_NEAR(path[999].x(), 4e-3, 1e-12);
}

// ---- on the organs ----

class ObserverOnOrgans : public testing::Test {
 protected:
  static Protocol protocol_of(const std::string& text) {
    const test::TemporaryFolder folder;
    test::write(folder / "p.toml", text);
    return load_protocol(folder / "p.toml");
  }
  static Stimuli compile(const Protocol& protocol) {
    sim::ComplianceCache cache("");
    return compile_stimuli(protocol, cache);
  }
  static SimulatedTrial play_one(const Protocol& protocol, const Stimuli& stimuli, std::size_t cell,
                                 int number) {
    ObserverParameters p = test::plain_observer();
    p.depth.within = 2e-4;
    p.drift = 1e-4;
    Generator person = make_generator(1, "person");
    const Observer observer = draw_observer(p, person);
    SessionRow sitting{.number = 1};
    sitting.facts.examinee = "S01";
    sitting.facts.seed = 5;
    DrawnTrial drawn;
    drawn.trial.number = number;
    drawn.trial.cell = cell;
    drawn.trial.interval_condition = {protocol.presented[0], protocol.presented[1]};
    return play(protocol, stimuli, observer, sitting, drawn);
  }
};

TEST_F(ObserverOnOrgans, NamesOfConditionsChangeNoTraceAndNoAnswer) {
  const std::string text = test::shipped_text();
  std::string renamed = test::with(text, "soft", "@");
  renamed = test::with(test::with(renamed, "hard", "soft"), "@", "hard");
  const Protocol a = protocol_of(text), b = protocol_of(renamed);
  ASSERT_EQ(b.conditions[0].name, "hard");
  const Stimuli at_a = compile(a), at_b = compile(b);
  for (int number = 1; number <= 4; ++number) {
    const SimulatedTrial in_a = play_one(a, at_a, 0, number), in_b = play_one(b, at_b, 0, number);
    EXPECT_EQ(in_a.response, in_b.response);
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_EQ(in_a.presentations.at(i).trace, in_b.presentations.at(i).trace);
  }
}

TEST_F(ObserverOnOrgans, TheModelOfThePaperTellsConditionsApartAndSibillesDoesNot) {
  const Protocol protocol = protocol_of(test::shipped_text());
  const Stimuli stimuli = compile(protocol);
  Generator generator = make_generator(1, "hand");
  const Observer observer{.parameters = nullptr, .depth = 5e-3, .duration = 0.6};
  ObserverParameters p = test::plain_observer();
  Observer pressing = observer;
  pressing.parameters = &p;
  const auto path = plan_press(pressing, sim::Vec3::UnitZ(), generator);
  const auto peak = [&](std::size_t cell, std::size_t condition) {
    const sim::Model& model = *stimuli.at(stimulus_index(protocol, cell, condition));
    sim::Simulation simulation(model);
    return summarise(drive(model, simulation, path, {}).trace).peak_force;
  };
  EXPECT_GT(peak(0, 1) / peak(0, 0), 1.1);
  EXPECT_NEAR(peak(1, 1) / peak(1, 0), 1.0, 1e-6);  // single precision of the trace
}

TEST_F(ObserverOnOrgans, ForceIsCutAsTheDeviceWould) {
  const Protocol protocol = protocol_of(test::shipped_text());
  const Stimuli stimuli = compile(protocol);
  ObserverParameters p = test::plain_observer();
  Generator generator = make_generator(1, "hand");
  const Observer observer = draw_observer(p, generator);
  const sim::Model& model = *stimuli.at(0);
  sim::Simulation simulation(model);
  const auto path = plan_press(observer, model.probes.front().direction, generator);
  const double whole = summarise(drive(model, simulation, path, {}).trace).peak_force;
  const IntervalRecord cut = drive(model, simulation, path, {.max_force = whole / 2});
  EXPECT_NEAR(summarise(cut.trace).peak_force, whole / 2, 1e-6 * whole);
  EXPECT_GT(cut.clamped_fraction, 0.3);
  EXPECT_LT(cut.clamped_fraction, 1.0);
  const double tenth = summarise(drive(model, simulation, path, {.force_scale = 0.1}).trace).peak_force;
  EXPECT_NEAR(tenth, whole / 10, 1e-6 * whole);
}

TEST_F(ObserverOnOrgans, ADeviceThatCutsBothConditionsToOneForceIsRefused) {
  const Protocol protocol = protocol_of(test::shipped_text());
  const Stimuli stimuli = compile(protocol);
  ObserverParameters p = test::plain_observer();
  EXPECT_NO_THROW(check_clamping(protocol, stimuli, p));
  p.device.max_force = 1.0;
  EXPECT_THROW(check_clamping(protocol, stimuli, p), std::invalid_argument);
}

}  // namespace
}  // namespace palpate::trials
