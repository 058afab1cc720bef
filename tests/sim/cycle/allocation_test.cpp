// The haptic cycle allocates nothing. Every way to the heap in this program ends in malloc, calloc, realloc
// or aligned_alloc: they are counted here while a cycle runs. Sanitizers replace them themselves.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/compile/compile.hpp"
#include "sim/compliance/cache.hpp"
#include "sim/cycle/press.hpp"
#include "tests/support/places.hpp"

namespace {

thread_local bool counting = false;
thread_local long allocations = 0;

void count() {
  if (counting) ++allocations;
}

}  // namespace

// glibc's own entries, which its manual allows a program to replace and which stay reachable by these names.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
  count();
  return __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) {
  count();
  return __libc_calloc(number, size);
}
void* realloc(void* block, std::size_t size) {
  count();
  return __libc_realloc(block, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  count();
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  count();
  *block = __libc_memalign(alignment, size);
  return *block == nullptr ? 12 : 0;  // ENOMEM
}
}

namespace palpate::sim {
namespace {

class Allocation : public testing::TestWithParam<const char*> {};

}  // namespace

TEST(AllocationCounter, SeesEveryWayToTheHeap) {
  allocations = 0;
  counting = true;
  const std::vector<double> numbers(1000, 1.0);
  const Eigen::VectorXd vector = Eigen::VectorXd::Constant(1000, numbers[7]);
  counting = false;
  EXPECT_EQ(allocations, 2) << vector[0];
}

// Down to full depth and back up, contacts coming and going, from the very first cycle on.
TEST_P(Allocation, NoneInTheCycle) {
  ComplianceCache cache("");
  const auto file =
      std::filesystem::path(palpate::test::source_folder()) / "data/scenes/rectal-palpation.toml";
  const Model model = compile(load_scene(file, std::vector<Override>{{"contact.model", GetParam()}}), cache);
  std::vector<std::vector<ProbePose>> poses;
  for (int k = -10; k <= 100; ++k) poses.push_back(pose_at_depth(model, 6e-3 * k / 100));
  for (int k = 100; k >= -10; --k) poses.push_back(pose_at_depth(model, 6e-3 * k / 100));
  Scratch scratch(model);
  int most = 0;
  allocations = 0;
  counting = true;
  for (const std::vector<ProbePose>& pose : poses) {
    const CycleResult result = cycle(model, {}, pose, scratch);
    if (!result.pairs.empty()) most = std::max(most, result.pairs[0].active);
  }
  counting = false;
  EXPECT_EQ(allocations, 0);
  if (std::string(GetParam()) != "none") EXPECT_GT(most, 10);
}

INSTANTIATE_TEST_SUITE_P(Laws, Allocation, testing::Values("none", "sibille", "kuroda"),
                         [](const auto& law) { return std::string(law.param); });

}  // namespace palpate::sim

#endif
