#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "app/loop/interval_engine.hpp"
#include "app/loop/snapshot.hpp"
#include "sim/model/model.hpp"

namespace palpate::app {

constexpr int kFrameWidth = 640, kFrameHeight = 480;
constexpr double kFramesPerSecond = 40;  // asked for; at least 30 must come

/// Draws the organs in a thread of its own while it is told to, from the newest state of the haptic loop; the
/// loop itself never waits for a picture.
class FrameStream {
 public:
  /// @param deliver  takes each JPEG; called on the stream's own thread
  FrameStream(const Snapshot<IntervalState>& state, std::function<void(const std::string& jpeg)> deliver);
  ~FrameStream();
  FrameStream(const FrameStream&) = delete;
  FrameStream& operator=(const FrameStream&) = delete;

  /// Draws `model` from now on; nullptr: nothing. The model must live as long as it is drawn, and after this
  /// returns the one before is not looked at any more.
  void show(const sim::Model* model);

  /// Empty, or why there are no pictures (the renderer refused).
  std::string failure() const;

 private:
  void draw();
  void draw_model(const sim::Model& model);
  bool wanted(const sim::Model& model) const;

  const Snapshot<IntervalState>& state_;
  std::function<void(const std::string&)> deliver_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  const sim::Model* model_ = nullptr;    // to draw
  const sim::Model* drawing_ = nullptr;  // being drawn
  std::string failure_;
  bool quit_ = false;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace palpate::app
