#include "app/loop/haptic_loop.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <memory>
#include <thread>

#include "devices/devices.hpp"
#include "tests/app/support/palpation.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::app {
namespace {

using namespace std::chrono_literals;

const IntervalLimits kManyPresses{.least_presses = 1, .most_presses = 50, .min_depth = 1e-3, .max_time = 5.0};

// On a busy machine cycles are missed; what must hold is that time is kept: cycles run and cycles missed
// together are the milliseconds that have passed.
TEST(HapticLoop, KeepsTimeAndCountsWhatItMisses) {
  const sim::Model model = test::palpation("kuroda", "1.0 MPa");
  HapticLoop loop(devices::open("mouse"));
  IntervalEngine engine(model, kManyPresses, loop.device());
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
  HapticLoop loop(devices::open("mouse"));
  loop.set_hand(-1e-3);
  IntervalEngine first(model, {.least_presses = 1, .most_presses = 1, .min_depth = 0, .max_time = 0.01},
                       loop.device());
  loop.run(first);
  while (!loop.state().over) std::this_thread::sleep_for(1ms);
  loop.stop();
  IntervalEngine second(model, kManyPresses, loop.device());
  loop.run(second);
  EXPECT_FALSE(loop.state().over);
  loop.forget_hand();
  loop.stop();
}

TEST(HapticLoop, StopsWithoutHavingRun) {
  HapticLoop loop(devices::open("mouse"));
  EXPECT_EQ(loop.stop().rate_hz, 0.0);
}

/// A device of the loop's own thread: it says where it is and keeps what it was given.
struct Recorder : devices::Handle {
  std::atomic<double> last{0.0};  // [N], along the press
};

const devices::Device kRecorder{
    .name = "recorder",
    .facts = {.gives_force = true, .continuous_force = 100.0},
    .read = [](devices::Handle&, const devices::Moment& moment) -> devices::Reading {
      const double depth = moment.since_begin < 0.05 ? -1e-3 : 2e-3;
      return {.position = depth * moment.press, .measured = moment.now, .known = true};
    },
    .move = [](devices::DrivenProbe& probe, const sim::Vec3& target, double,
               double step) { devices::hold_probe(probe, target, step); },
    .deliver = [](devices::Handle& handle,
                  const sim::Vec3& force) { static_cast<Recorder&>(handle).last = force[2]; }};

TEST(HapticLoop, GivesTheForceBackToTheDevice) {
  const sim::Model model = test::palpation("kuroda", "1.0 MPa");
  auto handle = std::make_unique<Recorder>();
  const Recorder& recorder = *handle;
  HapticLoop loop({.device = &kRecorder, .handle = std::move(handle)});
  loop.set_hand(5e-3);  // such a device does not listen to the page
  IntervalEngine engine(model, kManyPresses, loop.device());
  loop.run(engine);
  while (loop.state().depth < 2e-3) std::this_thread::sleep_for(1ms);
  std::this_thread::sleep_for(20ms);
  loop.stop();
  EXPECT_LT(recorder.last, -1.0);  // out of the tissue
  EXPECT_EQ(recorder.last, engine.force_on_hand()[2]);
}

TEST(HapticLoop, PlaysAScriptInTheTimeOfTheInterval) {
  const palpate::test::TemporaryFolder folder;
  std::ofstream(folder / "press.csv") << "time_s,finger.x_m,finger.y_m,finger.z_m\n"
                                         "0,0,0,-0.001\n"
                                         "0.05,0,0,-0.001\n"
                                         "0.1,0,0,0.003\n"
                                         "0.15,0,0,-0.001\n";
  const sim::Model model = test::palpation("kuroda", "1.0 MPa");
  HapticLoop loop(devices::open("scripted:" + (folder / "press.csv").string()));
  for (int interval = 0; interval < 2; ++interval) {
    IntervalEngine engine(model, {.least_presses = 1, .most_presses = 1, .max_time = 1.0}, loop.device());
    loop.run(engine);
    while (!loop.state().over) std::this_thread::sleep_for(1ms);
    loop.stop();
    EXPECT_EQ(trials::summarise(engine.trace()).presses, 1) << "interval " << interval;
    EXPECT_GT(trials::summarise(engine.trace()).max_depth, 2e-3);
  }
}

}  // namespace
}  // namespace palpate::app
