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
thread_local std::size_t bytes = 0;

void count(std::size_t size) {
  if (!counting) return;
  ++allocations;
  bytes += size;
}

}  // namespace

// glibc's own entries, which its manual allows a program to replace and which stay reachable by these names.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
  count(size);
  return __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) {
  count(number * size);
  return __libc_calloc(number, size);
}
void* realloc(void* block, std::size_t size) {
  count(size);
  return __libc_realloc(block, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  count(size);
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  count(size);
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

namespace {

/// Heap that a simulation of the scene of Table 1 takes.
std::size_t bytes_of_simulation(const std::vector<Override>& overrides) {
  ComplianceCache cache("");
  const auto file =
      std::filesystem::path(palpate::test::source_folder()) / "data/scenes/rectal-palpation.toml";
  const Model model = compile(load_scene(file, overrides), cache);
  bytes = 0;
  counting = true;
  const Simulation simulation(model);
  counting = false;
  return bytes;
}

}  // namespace

// With `none` nothing is there for contact: no pairs, trees, claims or factors, just as where there is
// nothing to touch.
TEST(AllocationOfLaw, NoneTakesNothingForContact) {
  const std::size_t none = bytes_of_simulation({{"contact.model", "none"}});
  EXPECT_EQ(none, bytes_of_simulation({{"contact.model", "none"}, {"contact.touch", "[]"}}));
  EXPECT_EQ(none, bytes_of_simulation({{"contact.model", "kuroda"}, {"contact.touch", "[]"}}));

  // Beside the body that the probe presses, another costs its loads and its two displacements, in three rows.
  const std::size_t alone = bytes_of_simulation({{"bodies.prostate.present", "false"}});
  ComplianceCache cache("");
  const auto file =
      std::filesystem::path(palpate::test::source_folder()) / "data/scenes/rectal-palpation.toml";
  const Model both = compile(load_scene(file), cache);
  std::size_t vectors = 0;
  for (const Body& body : both.bodies)
    if (body.name == "prostate") vectors = 3 * sizeof(double) * static_cast<std::size_t>(body.rest.size());
  EXPECT_GT(none, alone);
  EXPECT_LT(none, alone + vectors + 1000);

  const std::size_t sibille = bytes_of_simulation({{"contact.model", "sibille"}});
  EXPECT_GT(sibille, 10 * none);
  EXPECT_GT(bytes_of_simulation({{"contact.model", "kuroda"}}), sibille * 3 / 2);  // a second factor a body
}

// Down to full depth and back up, contacts coming and going, from the very first cycle on.
TEST_P(Allocation, NoneInTheCycle) {
  ComplianceCache cache("");
  const auto file =
      std::filesystem::path(palpate::test::source_folder()) / "data/scenes/rectal-palpation.toml";
  const Model model = compile(load_scene(file, std::vector<Override>{{"contact.model", GetParam()}}), cache);
  std::vector<std::vector<ProbeDisplacement>> poses;
  for (int k = -10; k <= 100; ++k) poses.push_back(displaced_by(model, 6e-3 * k / 100));
  for (int k = 100; k >= -10; --k) poses.push_back(displaced_by(model, 6e-3 * k / 100));
  Simulation simulation(model);
  int most = 0;
  allocations = 0;
  counting = true;
  for (const std::vector<ProbeDisplacement>& pose : poses) {
    const CycleResult result = simulation.step(pose, kCyclePeriod);
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
