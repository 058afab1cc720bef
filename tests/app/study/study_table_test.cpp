#include "app/study/study_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "app/study/force_curves.hpp"

using namespace palpate;

namespace {

// A press in `steps` equal steps to `depth` and back, with a force of `stiffness` newton a metre along z.
trials::Trace press(double depth, int steps, double stiffness) {
  trials::Trace trace;
  for (int i = 0; i <= 2 * steps; ++i) {
    const double d = depth * (1 - std::abs(i - steps) / static_cast<double>(steps));
    trials::TraceSample sample;
    sample.depth = static_cast<float>(d);
    sample.force = {0, 0, static_cast<float>(-stiffness * d)};
    trace.push_back(sample);
  }
  return trace;
}

}  // namespace

TEST(ForceAtDepths, InterpolatesALinearForceExactly) {
  // 1.1 mm in 7 steps: no sample lies on the 0.25 mm grid
  const std::vector<double> forces = app::force_at_depths(press(0.0011, 7, 400));
  ASSERT_EQ(forces.size(), 5u);  // 0 to 1.0 mm
  for (std::size_t i = 0; i < forces.size(); ++i) {
    EXPECT_NEAR(forces[i], 400 * 0.00025 * static_cast<double>(i), 1e-6);  // single precision of the trace
  }
}

TEST(ForceAtDepths, TakesTheMeanOverPressesAndOnlyTheWayIn) {
  trials::Trace trace = press(0.001, 10, 200), second = press(0.001, 10, 400);
  for (std::size_t i = 11; i < trace.size(); ++i) trace[i].force = {0, 0, 99};  // on the way out
  trace.insert(trace.end(), second.begin(), second.end());
  const std::vector<double> forces = app::force_at_depths(trace);
  EXPECT_NEAR(forces.at(2), 300 * 0.0005, 1e-6);
}

TEST(ForceAtDepths, KnowsNothingOfDepthsThatWereNotPassed) {
  EXPECT_TRUE(app::force_at_depths({}).empty());
  EXPECT_TRUE(app::force_at_depths(press(-0.001, 4, 100)).empty());
  trials::Trace inside = press(0.002, 8, 100);
  inside.erase(inside.begin(), inside.begin() + 5);  // begins 1.25 mm deep
  const std::vector<double> forces = app::force_at_depths(inside);
  EXPECT_TRUE(std::isnan(forces.at(3)));
  EXPECT_NEAR(forces.at(6), 0.15, 1e-6);
}
