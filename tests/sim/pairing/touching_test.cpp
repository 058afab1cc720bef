#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "sim/cycle/press.hpp"
#include "sim/pairing/find_pairs.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

/// A box of 5 mm lying on another one, both free to touch with all of their surface. They stand where sums of
/// heights are rounded.
Model lying_boxes() {
  const std::string all = R"({ lower = ["-1 m", "-1 m", "-1 m"], upper = ["1 m", "1 m", "1 m"] })";
  const std::vector<Override> placed{{"bodies.upper.touchable", all},
                                     {"bodies.lower.touchable", all},
                                     {"bodies.lower.offset", R"(["0.21 mm", "0.13 mm", "100 mm"])"},
                                     {"bodies.upper.offset", R"(["0 mm", "0 mm", "120 mm"])"},
                                     {"probes.finger.at", R"(["15 mm", "15 mm", "125 mm"])"}};
  return test::compile_scene(test::write_two_boxes(), placed);
}

// Whether a node has passed a polygon does not hang on the last bit of a distance: each node of the upper box goes
// straight down by just as much as it is then below the lower box's top.
TEST(Touching, EveryStepDownIsSeen) {
  const Model model = lying_boxes();
  FreeMotion motion(2);
  for (int i = 0; i < 2; ++i) motion[i].displacement = Eigen::VectorXd::Zero(3 * model.bodies[i].rest.cols());
  motion[0].moved = true;
  std::set<std::size_t> counts;
  for (int step = 1; step <= 200; ++step) {
    for (Eigen::Index node = 0; node < model.bodies[0].rest.cols(); ++node)
      motion[0].displacement[3 * node + 2] = -7.3e-6 * step;
    Placement placement = rest_placement(model);
    place(model, motion, placement);
    Pairs pairs;
    find_pairs(model, motion, placement, pairs);
    counts.insert(pairs.size());
  }
  EXPECT_EQ(counts.size(), 1U) << *counts.begin() << " to " << *counts.rbegin();
  EXPECT_GT(*counts.begin(), 20U);
}

// A node that has passed the near side of a body is not driven out through its far side, however near that has
// come.
TEST(Touching, APressThroughMostOfABodyLosesNoForce) {
  double before = 0.0;
  for (const PressStep& step : press(lying_boxes(), 4e-3, 40).curve) {
    const double force = step.probe_forces[0].z();
    EXPECT_GT(force, before) << step.depth;
    before = force;
  }
}

}  // namespace
}  // namespace palpate::sim
