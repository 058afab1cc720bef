// A tick of an interval allocates nothing, whether a picture asks for its loads or not. As in
// tests/sim/cycle/allocation_test.cpp the ways to the heap are counted; sanitizers replace them themselves.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "app/loop/interval_engine.hpp"
#include "devices/devices.hpp"
#include "tests/app/support/palpation.hpp"

namespace {

thread_local bool counting_ticks = false;
thread_local long tick_allocations = 0;

void count_tick() {
  if (counting_ticks) ++tick_allocations;
}

}  // namespace

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
  count_tick();
  return __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) {
  count_tick();
  return __libc_calloc(number, size);
}
void* realloc(void* block, std::size_t size) {
  count_tick();
  return __libc_realloc(block, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  count_tick();
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  count_tick();
  *block = __libc_memalign(alignment, size);
  return *block == nullptr ? 12 : 0;  // ENOMEM
}
}

namespace palpate::app {
namespace {

TEST(IntervalEngineAllocation, NoneInATickNorInReadingTheDeviceNorInHandingOver) {
  const sim::Model model = test::palpation("kuroda", "5.0 MPa");
  const devices::OpenDevice mouse = devices::open("mouse");
  IntervalEngine engine(model, {.least_presses = 1, .most_presses = 3, .max_time = 3.0}, *mouse.device);
  int answers = 0;
  tick_allocations = 0;
  counting_ticks = true;
  for (int i = 0; i < 2000; ++i) {
    const double depth = 5e-3 - 6e-3 * std::cos(2 * std::numbers::pi * i * kCycleSeconds);
    mouse.device->tell(*mouse.handle, depth, i);
    const devices::Reading hand = mouse.device->read(*mouse.handle, {.now = i, .press = engine.press()});
    if (i % 16 == 0) engine.felt().ask();
    engine.tick({.position = hand.position, .known = hand.known});
    answers += engine.felt().answer() != nullptr;
  }
  counting_ticks = false;
  EXPECT_EQ(tick_allocations, 0);
  EXPECT_EQ(answers, 2000);  // an answer stays until the next question
}

TEST(IntervalEngineAllocation, IsCounted) {
  tick_allocations = 0;
  counting_ticks = true;
  const Eigen::VectorXd vector = Eigen::VectorXd::Constant(1000, 1.0);
  counting_ticks = false;
  EXPECT_EQ(tick_allocations, 1) << vector[7];
}

}  // namespace
}  // namespace palpate::app

#endif
