#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/compile/compile.hpp"
#include "sim/compliance/cache.hpp"
#include "sim/cycle/press.hpp"
#include "tests/sim/support/body_table.hpp"
#include "tests/sim/support/region_boxes.hpp"
#include "tests/sim/support/two_boxes.hpp"
#include "tests/support/heap_use.hpp"
#include "tests/support/places.hpp"

namespace palpate::sim {
namespace {

using palpate::test::heap_use;
using palpate::test::kHeapIsCounted;

constexpr const char* kNotCounted = "sanitizers have a heap of their own";

class Allocation : public testing::TestWithParam<const char*> {};

TEST(HeapUse, SeesEveryWayToTheHeap) {
  if (!kHeapIsCounted) GTEST_SKIP() << kNotCounted;
  const auto use = heap_use([] {
    const std::vector<double> numbers(1000, 1.0);
    const Eigen::VectorXd vector = Eigen::VectorXd::Constant(1000, numbers[7]);
    EXPECT_EQ(vector[0], 1.0);
  });
  EXPECT_EQ(use.allocations, 2);
  EXPECT_GE(use.bytes, 2 * 1000 * sizeof(double));
}

/// Heap that a simulation of the scene of Table 1 takes.
std::size_t bytes_of_simulation(const std::vector<Override>& overrides) {
  ComplianceCache cache("");
  const auto file =
      std::filesystem::path(palpate::test::source_folder()) / "data/scenes/rectal-palpation.toml";
  const Model model = compile(load_scene(file, overrides), cache);
  return heap_use([&] { const Simulation simulation(model); }).bytes;
}

// With `none` nothing is there for contact: no pairs, trees, claims or factors, just as where there is
// nothing to touch.
TEST(AllocationOfLaw, NoneTakesNothingForContact) {
  if (!kHeapIsCounted) GTEST_SKIP() << kNotCounted;
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
  if (!kHeapIsCounted) GTEST_SKIP() << kNotCounted;
  ComplianceCache cache("");
  const auto file =
      std::filesystem::path(palpate::test::source_folder()) / "data/scenes/rectal-palpation.toml";
  const Model model = compile(load_scene(file, std::vector<Override>{{"contact.model", GetParam()}}), cache);
  std::vector<std::vector<ProbeDisplacement>> poses;
  for (int k = -10; k <= 100; ++k) poses.push_back(displaced_by(model, 6e-3 * k / 100));
  for (int k = 100; k >= -10; --k) poses.push_back(displaced_by(model, 6e-3 * k / 100));
  Simulation simulation(model);
  int most = 0;
  const auto use = heap_use([&] {
    for (const std::vector<ProbeDisplacement>& pose : poses) {
      const CycleResult result = simulation.step(pose, kCyclePeriod);
      if (!result.pairs.empty()) most = std::max(most, result.pairs[0].active);
    }
  });
  EXPECT_EQ(use.allocations, 0);
  if (std::string(GetParam()) != "none") EXPECT_GE(most, 10);
}

INSTANTIATE_TEST_SUITE_P(Laws, Allocation, testing::Values("none", "sibille", "kuroda", "exact"),
                         [](const auto& law) { return std::string(law.param); });

/// A scene, and the ways that its probes go.
struct Called {
  const char* name;
  Model (*model)();
  Vec3 way;  // of the first probe, to and fro
};

/// @param reach  of the region that carries the upper box; empty: what faces what stays as at rest
Model carried(const char* contact, const char* reach = "20 mm") {
  return test::compile_scene(test::write_region_boxes(
      test::without_fixed(test::body_table("upper", "z_min", "z_min")),
      test::body_table("lower", "z_min", "z_max"),
      std::string("[contact]\ntouch = [[\"upper\", \"lower\"]]\nmodel = \"exact\"\n") + contact,
      test::region_table("finger", "upper", "z_max", reach)));
}

/// The two boxes under `exact`, pressed by a probe of this kind.
Model two_boxes(const char* probe, std::vector<Override> contact = {}) {
  contact.push_back({"contact.model", "exact"});
  return test::compile_scene(test::write_two_boxes({.probe = probe}), contact);
}

constexpr const char* kPoint = "kind = \"point\"";
constexpr const char* kPad = "kind = \"pad\"\nradius = \"6 mm\"";
constexpr const char* kSlidingPad = "kind = \"pad\"\nradius = \"6 mm\"\nreach = \"4 mm\"";
constexpr const char* kFingertip = "kind = \"fingertip\"\nradius = \"7 mm\"\nreach = \"4 mm\"";
const Override kFriction{"contact.friction", "0.3"}, kTolerance{"contact.tolerance", "5 %"};

class AllocationOfEffect : public testing::TestWithParam<Called> {};

// For each effect and each kind of probe that a scene may call for, from the first touch on.
TEST_P(AllocationOfEffect, NoneInTheCycle) {
  if (!kHeapIsCounted) GTEST_SKIP() << kNotCounted;
  const Model model = GetParam().model();
  Simulation simulation(model);
  std::vector<ProbeDisplacement> at(model.probes.size());
  int most = 0;
  const auto use = heap_use([&] {
    for (int k = 0; k <= 400; ++k) {
      at.front().from_rest = (k <= 200 ? k : 400 - k) / 200.0 * GetParam().way;
      if (model.probes.front().region) at.front().rotation = Vec3(0, 0, 1e-4 * k);
      const CycleResult result = simulation.step(at, kCyclePeriod);
      most = std::max(most, result.pairs[0].active);
    }
  });
  EXPECT_EQ(use.allocations, 0);
  EXPECT_GE(most, 3);
}

INSTANTIATE_TEST_SUITE_P(
    Effects, AllocationOfEffect,
    testing::Values(
        Called{"Carried", [] { return carried(""); }, Vec3(4e-3, 2e-3, -0.8e-3)},
        Called{"CarriedWithFriction", [] { return carried("friction = 0.3\n"); }, Vec3(4e-3, 2e-3, -0.8e-3)},
        Called{"CarriedWithinTolerance", [] { return carried("tolerance = \"5 %\"\n"); },
               Vec3(4e-3, 2e-3, -0.8e-3)},
        Called{"RegionWithoutReach", [] { return carried("", ""); }, Vec3(0, 0, -1.5e-3)},
        Called{"Pad", [] { return two_boxes(kPad); }, Vec3(0.3e-3, 0, -1.5e-3)},
        Called{"Sliding", [] { return two_boxes(kSlidingPad); }, Vec3(3e-3, 1e-3, -1.5e-3)},
        Called{"SlidingWithFriction", [] { return two_boxes(kSlidingPad, {kFriction}); },
               Vec3(3e-3, 1e-3, -1.5e-3)},
        Called{"SlidingWithinTolerance", [] { return two_boxes(kSlidingPad, {kTolerance}); },
               Vec3(3e-3, 1e-3, -1.5e-3)},
        Called{"Fingertip", [] { return two_boxes(kFingertip); }, Vec3(2e-3, 1e-3, -3e-3)},
        Called{"FingertipWithinTolerance", [] { return two_boxes(kFingertip, {kTolerance}); },
               Vec3(2e-3, 1e-3, -3e-3)},
        Called{"FrictionUnderAPoint", [] { return two_boxes(kPoint, {kFriction}); },
               Vec3(0.3e-3, 0, -1.5e-3)},
        Called{"WithinTolerance", [] { return two_boxes(kPoint, {kTolerance}); }, Vec3(0, 0, -1.5e-3)}),
    [](const auto& called) { return std::string(called.param.name); });

}  // namespace
}  // namespace palpate::sim
