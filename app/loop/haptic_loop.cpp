#include "app/loop/haptic_loop.hpp"

#include <pthread.h>
#include <sched.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

namespace palpate::app {
namespace {

constexpr std::int64_t kPeriod = 1'000'000;  // [ns]

std::int64_t monotonic_now() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * 1'000'000'000LL + now.tv_nsec;
}

void sleep_until(std::int64_t deadline) {
  const timespec at{.tv_sec = deadline / 1'000'000'000, .tv_nsec = deadline % 1'000'000'000};
  while (::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr) != 0) {
  }
}

bool ask_for_real_time(std::thread& thread) {
  const sched_param priority{.sched_priority = 20};
  return ::pthread_setschedparam(thread.native_handle(), SCHED_FIFO, &priority) == 0;
}

}  // namespace

HapticLoop::HapticLoop(devices::OpenDevice device) : device_(std::move(device)), thread_([this] { loop(); }) {
  real_time_ = ask_for_real_time(thread_);
}

HapticLoop::~HapticLoop() {
  quit_ = true;
  thread_.join();
}

void HapticLoop::set_hand(double depth) {
  if (device().tell != nullptr) device().tell(*device_.handle, depth, monotonic_now());
}

void HapticLoop::forget_hand() {
  if (device().tell != nullptr) device().tell(*device_.handle, std::nullopt, monotonic_now());
}

void HapticLoop::run(IntervalEngine& engine) {
  engine_ = &engine;
  wait_for_the_loop();  // state() now tells of this engine and no earlier one
}

trials::LoopTiming HapticLoop::stop() {
  engine_ = nullptr;
  wait_for_the_loop();
  return clock_.timing();
}

/// A cycle that was under way may have seen the engine before; the one after it has not.
void HapticLoop::wait_for_the_loop() const {
  const std::uint64_t wanted = cycles_ + 2;
  while (cycles_ < wanted) std::this_thread::sleep_for(std::chrono::microseconds(200));
}

void HapticLoop::tick(IntervalEngine& engine, int elapsed, std::int64_t now, double since_begin) {
  const devices::Reading hand =
      device().read(*device_.handle, {.now = now, .since_begin = since_begin, .press = engine.press()});
  const double age = static_cast<double>(now - hand.measured) * 1e-9;
  engine.tick({.position = hand.position, .age = age, .known = hand.known}, elapsed);
  if (device().deliver != nullptr) device().deliver(*device_.handle, engine.force_on_hand());
  state_.write(engine.state());
}

void HapticLoop::loop() {
  IntervalEngine* running = nullptr;
  std::int64_t since_begin = 0;  // [cycles]
  std::int64_t deadline = monotonic_now(), before = deadline;
  while (!quit_) {
    deadline += kPeriod;
    sleep_until(deadline);
    const std::int64_t now = monotonic_now();
    const std::int64_t missed = std::max<std::int64_t>(0, (now - deadline) / kPeriod);
    deadline += missed * kPeriod;

    IntervalEngine* const engine = engine_;
    if (engine != nullptr && engine == running) {
      clock_.add(std::chrono::nanoseconds(now - before), missed);
      since_begin += 1 + missed;
      tick(*engine, static_cast<int>(1 + missed), now, static_cast<double>(since_begin) * kCycleSeconds);
    } else if (engine != nullptr) {
      clock_.reset();
      since_begin = 0;
      tick(*engine, 1, now, 0.0);
    }
    running = engine;
    before = now;
    ++cycles_;
  }
}

}  // namespace palpate::app
