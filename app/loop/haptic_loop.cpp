#include "app/loop/haptic_loop.hpp"

#include <pthread.h>
#include <sched.h>
#include <time.h>

#include <algorithm>
#include <chrono>

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

HapticLoop::HapticLoop() : thread_([this] { loop(); }) {
  real_time_ = ask_for_real_time(thread_);
}

HapticLoop::~HapticLoop() {
  quit_ = true;
  thread_.join();
}

void HapticLoop::set_hand(double depth) {
  hand_.write({.depth = depth, .measured = monotonic_now(), .known = true});
}

void HapticLoop::forget_hand() {
  hand_.write({});
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

void HapticLoop::loop() {
  IntervalEngine* running = nullptr;
  Hand hand;
  std::int64_t deadline = monotonic_now(), before = deadline;
  while (!quit_) {
    deadline += kPeriod;
    sleep_until(deadline);
    const std::int64_t now = monotonic_now();
    const std::int64_t missed = std::max<std::int64_t>(0, (now - deadline) / kPeriod);
    deadline += missed * kPeriod;

    IntervalEngine* const engine = engine_;
    if (engine != nullptr && engine == running) clock_.add(std::chrono::nanoseconds(now - before), missed);
    if (engine != nullptr && engine != running) clock_.reset();
    if (engine != nullptr) {
      hand = hand_.try_read().value_or(hand);
      const double age = static_cast<double>(now - hand.measured) * 1e-9;
      const int elapsed = engine == running ? static_cast<int>(1 + missed) : 1;
      engine->tick({.depth = hand.depth, .age = age, .known = hand.known}, elapsed);
      state_.write(engine->state());
    }
    running = engine;
    before = now;
    ++cycles_;
  }
}

}  // namespace palpate::app
