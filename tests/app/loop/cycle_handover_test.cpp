#include "app/loop/cycle_handover.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "sim/cycle/simulation.hpp"
#include "tests/app/support/palpation.hpp"

namespace palpate::app {
namespace {

using namespace std::chrono_literals;

/// Displacements and loads that hold one number everywhere, unless torn.
struct Uniform {
  explicit Uniform(const sim::Model& model)
      : probes(model.probes.size()), loads(sim::Simulation(model).loads()) {}
  void fill(double value) {
    for (sim::ProbeDisplacement& probe : probes) probe.from_rest.setConstant(value);
    for (Eigen::VectorXd& forces : loads.on_body) forces.setConstant(value);
  }
  CycleHandover handover(const sim::Model& model) { return {model, probes, loads}; }

  std::vector<sim::ProbeDisplacement> probes;
  sim::Loads loads;
};

bool holds_one_number(const FeltCycle& cycle) {
  const double value = cycle.probes.front().from_rest[0];
  bool same = true;
  for (const sim::ProbeDisplacement& probe : cycle.probes) same &= (probe.from_rest.array() == value).all();
  for (const Eigen::VectorXd& forces : cycle.loads.on_body) same &= (forces.array() == value).all();
  return same;
}

TEST(CycleHandover, GivesTheCycleAfterTheQuestionAndKeepsIt) {
  const sim::Model model = test::palpation("none", "1.0 MPa");
  Uniform felt(model);
  CycleHandover handover = felt.handover(model);
  felt.fill(1);
  handover.offer(felt.probes, felt.loads);
  EXPECT_EQ(handover.answer(), nullptr);  // nobody has asked
  handover.ask();
  EXPECT_EQ(handover.answer(), nullptr);
  felt.fill(2);
  handover.offer(felt.probes, felt.loads);
  felt.fill(3);
  handover.offer(felt.probes, felt.loads);
  const FeltCycle* answer = handover.answer();
  ASSERT_NE(answer, nullptr);
  EXPECT_EQ(answer->loads.on_body[1][0], 2);
  handover.ask();
  handover.offer(felt.probes, felt.loads);
  ASSERT_NE(handover.answer(), nullptr);
  EXPECT_EQ(handover.answer()->probes[0].from_rest[2], 3);
}

// Run under the tsan preset this also proves that there is no data race. The reader asks again and again,
// now and then before it was answered.
TEST(CycleHandover, IsNeverTornWhileTheLoopOffersAsFastAsItCan) {
  const sim::Model model = test::palpation("none", "1.0 MPa");
  Uniform felt(model);
  CycleHandover handover = felt.handover(model);
  std::atomic<bool> done{false};
  std::thread loop([&] {
    for (double number = 1; !done; ++number) {
      felt.fill(number);
      handover.offer(felt.probes, felt.loads);
    }
  });
  int answers = 0, torn = 0, backwards = 0;
  double before = 0;
  const auto until = std::chrono::steady_clock::now() + 5s;
  const auto time_is_left = [&] { return std::chrono::steady_clock::now() < until; };
  for (int k = 0; answers < 2000 && time_is_left(); ++k) {
    handover.ask();
    while (k % 5 != 0 && handover.answer() == nullptr && time_is_left()) std::this_thread::yield();
    const FeltCycle* cycle = handover.answer();
    if (cycle == nullptr) continue;
    ++answers;
    torn += !holds_one_number(*cycle);
    backwards += cycle->probes.front().from_rest[0] < before;
    before = cycle->probes.front().from_rest[0];
  }
  done = true;
  loop.join();
  EXPECT_GT(answers, 0);
  EXPECT_EQ(torn, 0);
  EXPECT_EQ(backwards, 0);
}

}  // namespace
}  // namespace palpate::app
