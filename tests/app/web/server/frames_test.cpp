#include "app/web/server/frames.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "app/loop/interval_engine.hpp"
#include "devices/mouse/mouse.hpp"
#include "sim/cycle/simulation.hpp"
#include "sim/view/image.hpp"
#include "sim/view/picture_of.hpp"
#include "sim/view/renderer.hpp"
#include "tests/app/support/palpation.hpp"

namespace palpate::app {
namespace {

using namespace std::chrono_literals;

/// The last picture that was delivered.
class LastPicture {
 public:
  void take(const std::string& jpeg) {
    const std::lock_guard lock(mutex_);
    jpeg_ = jpeg;
    came_.notify_all();
  }
  std::string wait() {
    std::unique_lock lock(mutex_);
    came_.wait_for(lock, 30s, [&] { return !jpeg_.empty(); });
    return jpeg_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable came_;
  std::string jpeg_;
};

/// A picture of a press that solves the cycle by itself, as a judge.
std::string drawn_anew(const sim::Model& model, const std::vector<sim::ProbeDisplacement>& probes) {
  sim::Simulation simulation(model);
  simulation.step(probes, kCycleSeconds);
  sim::Renderer renderer(kFrameWidth, kFrameHeight);
  const sim::Stage stage = sim::set_stage(model, double(kFrameWidth) / kFrameHeight);
  return sim::encode_jpeg(renderer.render(sim::picture_of(model, stage, simulation.loads(), probes)), 80);
}

// The interval ends by its time while the finger is deep in: what was felt then stays.
TEST(FrameStream, DrawsTheCycleThatTheHandFeltByteForByte) {
  const sim::Model model = test::palpation("kuroda", "5.0 MPa");
  IntervalEngine engine(model, {.least_presses = 1, .most_presses = 1, .max_time = 0.2}, devices::mouse());
  for (int i = 0; !engine.state().over; ++i)
    engine.tick({.position = {0, 0, i == 0 ? -1e-3 : 8e-3}, .known = true});
  engine.felt().ask();
  engine.tick({});
  const FeltCycle* felt = engine.felt().answer();
  ASSERT_NE(felt, nullptr);
  const std::vector<sim::ProbeDisplacement> probes = felt->probes;
  ASSERT_GT(probes.front().from_rest[2], 3e-3);

  LastPicture last;
  FrameStream frames([&](const std::string& jpeg) { last.take(jpeg); });
  std::atomic<bool> done{false};
  std::thread loop([&] {
    while (!done) {
      engine.tick({});
      std::this_thread::sleep_for(1ms);
    }
  });
  frames.show(&engine.felt());
  const std::string shown = last.wait();
  frames.show(nullptr);
  done = true;
  loop.join();
  EXPECT_EQ(frames.failure(), "");
  EXPECT_TRUE(shown == drawn_anew(model, probes));
  EXPECT_FALSE(shown == drawn_anew(model, std::vector<sim::ProbeDisplacement>(probes.size())));
}

// No loop runs, so no cycle ever comes: the stream lets go all the same.
TEST(FrameStream, LetsGoWhileItWaitsForACycle) {
  const sim::Model model = test::palpation("none", "1.0 MPa");
  IntervalEngine engine(model, {}, devices::mouse());
  std::atomic<int> pictures{0};
  FrameStream frames([&](const std::string&) { ++pictures; });
  frames.show(&engine.felt());
  std::this_thread::sleep_for(20ms);
  frames.show(nullptr);
  EXPECT_EQ(pictures, 0);
}

}  // namespace
}  // namespace palpate::app
