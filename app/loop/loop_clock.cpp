#include "app/loop/loop_clock.hpp"

#include <algorithm>
#include <cmath>

namespace palpate::app {

void LoopClock::reset() {
  bins_.fill(0);
  cycles_ = 0;
  total_ = longest_ = 0;
  missed_ = 0;
}

void LoopClock::add(std::chrono::nanoseconds period, long missed) {
  const std::int64_t bin = std::clamp<std::int64_t>(period.count() / kBinNanoseconds, 0,
                                                    static_cast<std::int64_t>(bins_.size()) - 1);
  ++bins_[bin];
  ++cycles_;
  total_ += period.count();
  longest_ = std::max<std::int64_t>(longest_, period.count());
  missed_ += missed;
}

trials::LoopTiming LoopClock::timing() const {
  if (cycles_ == 0) return {};
  const auto wanted = static_cast<std::uint64_t>(std::ceil(0.999 * static_cast<double>(cycles_)));
  std::uint64_t seen = 0;
  std::size_t bin = 0;
  while (bin + 1 < bins_.size() && (seen += bins_[bin]) < wanted) ++bin;
  const std::int64_t edge = (static_cast<std::int64_t>(bin) + 1) * kBinNanoseconds;
  const std::int64_t p999 = bin + 1 == bins_.size() ? longest_ : std::min(edge, longest_);
  return {.rate_hz = static_cast<double>(cycles_) * 1e9 / static_cast<double>(total_),
          .p999_ms = static_cast<double>(p999) * 1e-6,
          .missed_cycles = missed_};
}

}  // namespace palpate::app
