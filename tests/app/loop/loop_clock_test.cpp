#include "app/loop/loop_clock.hpp"

#include <gtest/gtest.h>

namespace palpate::app {
namespace {

using namespace std::chrono_literals;

TEST(LoopClock, SaysNothingOfNothing) {
  EXPECT_EQ(LoopClock().timing().rate_hz, 0.0);
}

// 1999 periods of 1 ms and one of 3 ms: 2000 cycles in 2.002 s; 99.9 % of them, 1998, took at most 1 ms.
TEST(LoopClock, RateMissesAndPercentile) {
  LoopClock clock;
  for (int i = 0; i < 1999; ++i) clock.add(1ms, 0);
  clock.add(3ms, 2);
  const trials::LoopTiming timing = clock.timing();
  EXPECT_NEAR(timing.rate_hz, 2000 / 2.002, 1e-9);
  EXPECT_NEAR(timing.p999_ms, 1.0, 0.0101);  // a bin is 10 microseconds wide
  EXPECT_EQ(timing.missed_cycles, 2);
}

TEST(LoopClock, APercentileBeyondTheLastBinIsTheLongestPeriod) {
  LoopClock clock;
  clock.add(250ms, 249);
  EXPECT_DOUBLE_EQ(clock.timing().p999_ms, 250.0);
  clock.reset();
  EXPECT_EQ(clock.timing().missed_cycles, 0);
}

}  // namespace
}  // namespace palpate::app
