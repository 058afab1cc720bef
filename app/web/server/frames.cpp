#include "app/web/server/frames.hpp"

#include <chrono>
#include <exception>

#include "sim/view/image.hpp"
#include "sim/view/picture_of.hpp"
#include "sim/view/renderer.hpp"

namespace palpate::app {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kBetweenFrames =
    std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / kFramesPerSecond));
constexpr auto kBetweenLooks = std::chrono::microseconds(200);  // while a cycle is awaited
constexpr int kJpegQuality = 80;

}  // namespace

FrameStream::FrameStream(std::function<void(const std::string&)> deliver)
    : deliver_(std::move(deliver)), thread_([this] { draw(); }) {}

FrameStream::~FrameStream() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
    felt_ = nullptr;
  }
  changed_.notify_all();
  thread_.join();
}

void FrameStream::show(CycleHandover* felt) {
  std::unique_lock lock(mutex_);
  felt_ = felt;
  changed_.notify_all();
  changed_.wait(lock, [&] { return drawing_ == nullptr || drawing_ == felt; });
}

std::string FrameStream::failure() const {
  const std::lock_guard lock(mutex_);
  return failure_;
}

bool FrameStream::wanted(const CycleHandover& felt) const {
  const std::lock_guard lock(mutex_);
  return felt_ == &felt;
}

void FrameStream::draw() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return quit_ || felt_ != nullptr; });
    if (quit_) return;
    drawing_ = felt_;
    CycleHandover& felt = *drawing_;
    lock.unlock();
    std::string trouble;
    try {
      draw_cycles(felt);
    } catch (const std::exception& error) {
      trouble = error.what();  // a session goes on without pictures of the practice
    }
    lock.lock();
    drawing_ = nullptr;
    if (!trouble.empty()) {
      failure_ = trouble;
      felt_ = nullptr;
    }
    changed_.notify_all();
  }
}

/// The loop answers within a cycle; nothing once the drawing is over.
const FeltCycle* FrameStream::next_cycle(CycleHandover& felt) const {
  felt.ask();
  while (wanted(felt)) {
    if (const FeltCycle* cycle = felt.answer()) return cycle;
    std::this_thread::sleep_for(kBetweenLooks);
  }
  return nullptr;
}

void FrameStream::draw_cycles(CycleHandover& felt) {
  sim::Renderer renderer(kFrameWidth, kFrameHeight);
  const sim::Stage stage = sim::set_stage(felt.model(), double(kFrameWidth) / kFrameHeight);
  auto due = Clock::now();
  while (const FeltCycle* cycle = next_cycle(felt)) {
    const sim::Picture picture = sim::picture_of(felt.model(), stage, cycle->loads, cycle->probes);
    deliver_(sim::encode_jpeg(renderer.render(picture), kJpegQuality));
    due = std::max(due + kBetweenFrames, Clock::now());
    std::this_thread::sleep_until(due);
  }
}

}  // namespace palpate::app
