#include "sim/cost/tolerance_cost.hpp"

#include <gtest/gtest.h>

#include "sim/contact/laws.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

constexpr double kTolerances[] = {0.0, 0.01, 0.5};
constexpr CycleSampling kSampling{.depth = 1e-3, .poses = 12, .most_cycles = 40};

TEST(MeasureTolerances, ALawThatApproximatesNothingHasNone) {
  const Model model = test::compile_scene(test::write_two_boxes());
  for (const char* law : {"none", "sibille", "kuroda"})
    EXPECT_TRUE(measure_tolerances(model, contact_law(law), kSampling, kTolerances).empty()) << law;
}

// What bounds and counts promise; that a cycle which may stop early takes less time is no promise.
TEST(MeasureTolerances, KeepsEachToleranceAndSolvesToTheEndWithoutOne) {
  const Model model = test::compile_scene(test::write_two_boxes());
  const auto costs = measure_tolerances(model, contact_law("exact"), kSampling, kTolerances);
  ASSERT_EQ(costs.size(), 3U);
  for (std::size_t i = 0; i < costs.size(); ++i) {
    EXPECT_EQ(costs[i].tolerance, kTolerances[i]);
    EXPECT_EQ(costs[i].cycles, costs[0].cycles);
    EXPECT_GE(costs[i].cycles, 40);
    EXPECT_LE(costs[i].median_bound, costs[i].largest_bound);
    EXPECT_LE(costs[i].largest_bound, std::max(kTolerances[i], 1e-8));  // 1e-8: rounding, as force_bound_test
    EXPECT_GT(costs[i].total.median, 0.0);
  }
  EXPECT_EQ(costs[0].ended_early, 0);
  EXPECT_GT(costs[2].ended_early, 0);
  EXPECT_GT(costs[2].largest_bound, costs[0].largest_bound);
}

}  // namespace
}  // namespace palpate::sim
