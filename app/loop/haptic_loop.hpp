#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

#include "app/loop/interval_engine.hpp"
#include "app/loop/loop_clock.hpp"
#include "base/threads/snapshot.hpp"
#include "devices/device/device.hpp"
#include "trials/trace/trace.hpp"

namespace palpate::app {

/// The haptic loop: a thread that wakes at absolute deadlines 1 ms apart and ticks the engine that it was
/// given, with what it reads from the device; the force goes back there. States go out through a lock-free
/// snapshot; the thread itself neither allocates, locks, logs nor does I/O. It runs under SCHED_FIFO where
/// the system permits. All functions are for one other thread, but state(), which any thread may read.
class HapticLoop {
 public:
  /// Throws std::system_error when the system gives no thread.
  explicit HapticLoop(devices::OpenDevice device);
  ~HapticLoop();
  HapticLoop(const HapticLoop&) = delete;
  HapticLoop& operator=(const HapticLoop&) = delete;

  const devices::Device& device() const { return *device_.device; }
  /// The hand's newest place along the press as the page tells it [m]; looked at only by a device whose hand
  /// comes through the page.
  void set_hand(double depth);
  /// Forgets what the page told: until the next set_hand() the finger is taken to be lifted.
  void forget_hand();

  /// Ticks `engine` from the next cycle on; it must live until stop() has returned.
  void run(IntervalEngine& engine);
  /// Waits until the loop has let go of the engine, and says how it kept time meanwhile.
  trials::LoopTiming stop();

  IntervalState state() const { return state_.read(); }
  bool real_time() const { return real_time_; }  // whether SCHED_FIFO was granted

 private:
  void loop();
  void tick(IntervalEngine& engine, int elapsed, std::int64_t now, double since_begin);
  void wait_for_the_loop() const;

  devices::OpenDevice device_;
  base::Snapshot<IntervalState> state_;
  std::atomic<IntervalEngine*> engine_{nullptr};
  std::atomic<std::uint64_t> cycles_{0};  // completed; after one more, a changed engine_ has been seen
  std::atomic<bool> quit_{false};
  LoopClock clock_;     // the loop's while an engine runs
  std::thread thread_;  // last: it uses all of the above
  bool real_time_ = false;
};

}  // namespace palpate::app
