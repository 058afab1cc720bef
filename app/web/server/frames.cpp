#include "app/web/server/frames.hpp"

#include <chrono>
#include <exception>

#include "sim/cycle/simulation.hpp"
#include "sim/view/image.hpp"
#include "sim/view/picture_of.hpp"
#include "sim/view/renderer.hpp"

namespace palpate::app {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kBetweenFrames =
    std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / kFramesPerSecond));
constexpr int kJpegQuality = 80;

}  // namespace

FrameStream::FrameStream(const Snapshot<IntervalState>& state,
                         std::function<void(const std::string&)> deliver)
    : state_(state), deliver_(std::move(deliver)), thread_([this] { draw(); }) {}

FrameStream::~FrameStream() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
    model_ = nullptr;
  }
  changed_.notify_all();
  thread_.join();
}

void FrameStream::show(const sim::Model* model) {
  std::unique_lock lock(mutex_);
  model_ = model;
  changed_.notify_all();
  changed_.wait(lock, [&] { return drawing_ == nullptr || drawing_ == model; });
}

std::string FrameStream::failure() const {
  const std::lock_guard lock(mutex_);
  return failure_;
}

bool FrameStream::wanted(const sim::Model& model) const {
  const std::lock_guard lock(mutex_);
  return model_ == &model;
}

void FrameStream::draw() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return quit_ || model_ != nullptr; });
    if (quit_) return;
    drawing_ = model_;
    const sim::Model& model = *drawing_;
    lock.unlock();
    std::string trouble;
    try {
      draw_model(model);
    } catch (const std::exception& error) {
      trouble = error.what();  // a session goes on without pictures of the practice
    }
    lock.lock();
    drawing_ = nullptr;
    if (!trouble.empty()) {
      failure_ = trouble;
      model_ = nullptr;
    }
    changed_.notify_all();
  }
}

void FrameStream::draw_model(const sim::Model& model) {
  sim::Renderer renderer(kFrameWidth, kFrameHeight);
  const sim::Stage stage = sim::set_stage(model, double(kFrameWidth) / kFrameHeight);
  sim::Simulation simulation(model);
  std::vector<sim::ProbeDisplacement> probes(model.probes.size());
  auto due = Clock::now();
  while (wanted(model)) {
    probes.front().from_rest = state_.read().depth * model.probes.front().direction;
    simulation.step(probes, 1 / kFramesPerSecond);
    const sim::Picture picture = sim::picture_of(model, stage, simulation.loads(), probes);
    deliver_(sim::encode_jpeg(renderer.render(picture), kJpegQuality));
    due = std::max(due + kBetweenFrames, Clock::now());
    std::this_thread::sleep_until(due);
  }
}

}  // namespace palpate::app
