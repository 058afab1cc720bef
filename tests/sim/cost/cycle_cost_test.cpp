#include "sim/cost/cycle_cost.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "sim/contact/laws.hpp"
#include "sim/cycle/press.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

using test::compile_scene;
using test::write_two_boxes;

TEST(SpreadOf, IsTheSmallestTimeThatTheShareDoesNotExceed) {
  std::vector<double> times(1000);
  std::iota(times.rbegin(), times.rend(), 1.0);  // 1 to 1000, backwards
  const Percentiles spread = percentiles_of(times);
  EXPECT_EQ(spread.median, 500.0);
  EXPECT_EQ(spread.p99, 990.0);
  EXPECT_EQ(spread.p999, 999.0);
  EXPECT_EQ(spread.slowest, 1000.0);
  EXPECT_EQ(percentiles_of({7.0}).median, 7.0);
  EXPECT_THROW(percentiles_of({}), std::invalid_argument);
}

TEST(FinalContactSet, WithoutContactIsTheProbesOwnColumns) {
  Model model = compile_scene(write_two_boxes());
  model.law = &contact_law("none");
  Simulation simulation(model);
  const std::vector<ProbeDisplacement> pose = displaced_by(model, 0.5e-3);
  simulation.step(pose, kCyclePeriod);
  const Eigen::MatrixXd& own = model.probes.front().compliance;
  const ContactSet set = final_contact_set(model, pose, simulation.loads());
  EXPECT_EQ(set.bytes, static_cast<std::size_t>(own.size()) * sizeof(double));
  EXPECT_NEAR(read_once(set), own.sum(), 1e-12 * own.cwiseAbs().sum());
}

TEST(FinalContactSet, WithContactHasThreeColumnsOfEachLoadedNode) {
  Model model = compile_scene(write_two_boxes());
  model.law = &contact_law("kuroda");
  Simulation simulation(model);
  const std::vector<ProbeDisplacement> pose = displaced_by(model, 1e-3);
  ASSERT_GT(simulation.step(pose, kCyclePeriod).pairs.front().active, 0);
  const Probe& probe = model.probes.front();
  std::size_t numbers = probe.compliance.size();
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Eigen::VectorXd& loads = simulation.loads().on_body[b];
    for (Eigen::Index node = 0; node < loads.size() / 3; ++node) {
      const bool held = static_cast<int>(b) == probe.body && node == probe.nodes.front();
      if (!held && loads.segment<3>(3 * node).norm() > 0)
        numbers += 3 * static_cast<std::size_t>(loads.size());
    }
  }
  EXPECT_EQ(final_contact_set(model, pose, simulation.loads()).bytes, numbers * sizeof(double));
}

TEST(MeasureCycle, TimesThePosesAtWhichBodiesTouch) {
  const Model model = compile_scene(write_two_boxes({.gap = 0.2e-3}));
  const CycleSampling options{.depth = 1e-3, .poses = 10, .most_cycles = 100};
  const CycleCost cost = measure_cycle(model, contact_law("kuroda"), options);
  EXPECT_TRUE(cost.touching);
  EXPECT_GT(cost.active, 0);
  EXPECT_EQ(cost.cycles, 100);
  // The probe's node is the first to come down, by no more than the probe: nothing touches before the gap.
  EXPECT_GT(cost.depths.front(), 0.2e-3);
  EXPECT_LT(cost.depths.size(), 10U);
  EXPECT_EQ(cost.depths.back(), 1e-3);
  EXPECT_EQ(cost.depth_medians.size(), cost.depths.size());
  ASSERT_EQ(cost.depth_p999.size(), cost.depths.size());
  for (std::size_t i = 0; i < cost.depths.size(); ++i) EXPECT_GE(cost.depth_p999[i], cost.depth_medians[i]);
  // So few cycles: the 99.9th percentile is the slowest, which is somebody's neighbour.
  EXPECT_EQ(*std::ranges::max_element(cost.depth_p999), cost.total.slowest);
  EXPECT_GT(cost.total.median, 0.0);
  EXPECT_GT(cost.limit, 0.0);
  EXPECT_LE(cost.total.median, cost.total.p99);
  EXPECT_LE(cost.total.p999, cost.total.slowest);
}

TEST(MeasureCycle, SaysWhenNothingTouches) {
  const Model model = compile_scene(write_two_boxes({.gap = 5e-3}));
  const CycleCost cost =
      measure_cycle(model, contact_law("sibille"), {.depth = 1e-3, .poses = 4, .most_cycles = 20});
  EXPECT_FALSE(cost.touching);
  EXPECT_EQ(cost.depths.size(), 4U);
  EXPECT_EQ(cost.active, 0);
  EXPECT_THROW(measure_cycle(model, contact_law("none"), {.depth = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace palpate::sim
