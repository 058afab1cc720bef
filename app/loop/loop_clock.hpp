#pragma once

#include <array>
#include <chrono>
#include <cstdint>

#include "trials/trace/trace.hpp"

namespace palpate::app {

/// Times between the starts of cycles, in bins of 10 microseconds: fixed memory, so that the loop can record
/// and never allocates.
class LoopClock {
 public:
  void reset();
  /// One cycle began `period` after the one before, having let `missed` deadlines pass.
  void add(std::chrono::nanoseconds period, long missed);
  /// Rate and p99.9 (the upper edge of its bin) of what was recorded; zeros where nothing was.
  trials::LoopTiming timing() const;

 private:
  static constexpr std::int64_t kBinNanoseconds = 10'000;
  std::array<std::uint32_t, 10'000> bins_{};  // 0 to 100 ms; the last one holds all that is longer
  std::uint64_t cycles_ = 0;
  std::int64_t total_ = 0, longest_ = 0;  // [ns]
  long missed_ = 0;
};

}  // namespace palpate::app
