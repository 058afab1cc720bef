#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/loop/interval_engine.hpp"
#include "devices/devices.hpp"
#include "tests/app/support/palpation.hpp"
#include "tests/support/heap_use.hpp"

namespace palpate::app {
namespace {

TEST(IntervalEngineAllocation, NoneInATickNorInReadingTheDeviceNorInHandingOver) {
  if (!palpate::test::kHeapIsCounted) GTEST_SKIP() << "sanitizers have a heap of their own";
  const sim::Model model = test::palpation("kuroda", "5.0 MPa");
  const devices::OpenDevice mouse = devices::open("mouse");
  IntervalEngine engine(model, {.least_presses = 1, .most_presses = 3, .max_time = 3.0}, *mouse.device);
  int answers = 0;
  const palpate::test::HeapUse use = palpate::test::heap_use([&] {
    for (int i = 0; i < 2000; ++i) {
      const double depth = 5e-3 - 6e-3 * std::cos(2 * std::numbers::pi * i * kCycleSeconds);
      mouse.device->tell(*mouse.handle, depth, i);
      const devices::Reading hand = mouse.device->read(*mouse.handle, {.now = i, .press = engine.press()});
      if (i % 16 == 0) engine.felt().ask();
      engine.tick({.position = hand.position, .known = hand.known});
      answers += engine.felt().answer() != nullptr;
    }
  });
  EXPECT_EQ(use.allocations, 0);
  EXPECT_EQ(answers, 2000);  // an answer stays until the next question
}

}  // namespace
}  // namespace palpate::app
