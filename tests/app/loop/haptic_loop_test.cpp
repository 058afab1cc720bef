#include "app/loop/haptic_loop.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/app/support/palpation.hpp"

namespace palpate::app {
namespace {

using namespace std::chrono_literals;

const IntervalLimits kManyPresses{.least_presses = 1, .most_presses = 50, .min_depth = 1e-3, .max_time = 5.0};

// On a busy machine cycles are missed; what must hold is that time is kept: cycles run and cycles missed
// together are the milliseconds that have passed.
TEST(HapticLoop, KeepsTimeAndCountsWhatItMisses) {
  const sim::Model model = test::palpation("kuroda", "1.0 MPa");
  IntervalEngine engine(model, kManyPresses);
  HapticLoop loop;
  loop.set_hand(-1e-3);
  loop.run(engine);
  const auto begun = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - begun < 500ms) {
    loop.set_hand(-1e-3);
    std::this_thread::sleep_for(5ms);
  }
  const trials::LoopTiming timing = loop.stop();
  const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  const IntervalState state = engine.state();
  EXPECT_GT(timing.rate_hz, 0);
  EXPECT_LE(timing.rate_hz, 1100);
  EXPECT_NEAR(state.tick * kCycleSeconds, passed, 0.05);
  EXPECT_NEAR(static_cast<double>(engine.trace().size()) + static_cast<double>(timing.missed_cycles),
              state.tick, 3);
}

TEST(HapticLoop, StateBelongsToTheEngineThatRuns) {
  const sim::Model model = test::palpation("kuroda", "1.0 MPa");
  HapticLoop loop;
  loop.set_hand(-1e-3);
  IntervalEngine first(model, {.least_presses = 1, .most_presses = 1, .min_depth = 0, .max_time = 0.01});
  loop.run(first);
  while (!loop.state().over) std::this_thread::sleep_for(1ms);
  loop.stop();
  IntervalEngine second(model, kManyPresses);
  loop.run(second);
  EXPECT_FALSE(loop.state().over);
  loop.forget_hand();
  loop.stop();
}

TEST(HapticLoop, StopsWithoutHavingRun) {
  HapticLoop loop;
  EXPECT_EQ(loop.stop().rate_hz, 0.0);
}

}  // namespace
}  // namespace palpate::app
