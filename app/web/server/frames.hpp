#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "app/loop/cycle_handover.hpp"

namespace palpate::app {

constexpr int kFrameWidth = 640, kFrameHeight = 480;
constexpr double kFramesPerSecond = 40;  // asked for; at least 30 must come

/// Draws the organs in a thread of its own while it is told to, from the loads that the hand felt in the
/// newest cycle of the haptic loop; the loop itself never waits for a picture.
class FrameStream {
 public:
  /// @param deliver  takes each JPEG; called on the stream's own thread
  explicit FrameStream(std::function<void(const std::string& jpeg)> deliver);
  ~FrameStream();
  FrameStream(const FrameStream&) = delete;
  FrameStream& operator=(const FrameStream&) = delete;

  /// Draws what is felt there from now on; nullptr: nothing. It must live as long as it is drawn, and after
  /// this returns the one before is not looked at any more.
  void show(CycleHandover* felt);

  /// Empty, or why there are no pictures (the renderer refused).
  std::string failure() const;

 private:
  void draw();
  void draw_cycles(CycleHandover& felt);
  const FeltCycle* next_cycle(CycleHandover& felt) const;
  bool wanted(const CycleHandover& felt) const;

  std::function<void(const std::string&)> deliver_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  CycleHandover* felt_ = nullptr;     // to draw
  CycleHandover* drawing_ = nullptr;  // being drawn
  std::string failure_;
  bool quit_ = false;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace palpate::app
