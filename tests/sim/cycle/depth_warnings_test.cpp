#include "sim/cycle/depth_warnings.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "sim/cycle/press.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

using test::compile_scene;
using test::write_two_boxes;
using testing::AllOf;
using testing::HasSubstr;

std::vector<std::string> warnings_at(const Model& model, double depth) {
  return depth_warnings(model, depth, press(model, depth, 1).loads);
}

/// From the lowest to the highest node [m].
double height(const Body& body) {
  double low = INFINITY, high = -INFINITY;
  for (const Vec3& node : body.mesh->nodes) {
    low = std::min(low, node.z());
    high = std::max(high, node.z());
  }
  return high - low;
}

TEST(FarSide, IsAsFarAsTheBodyIsThick) {
  Model model = compile_scene(write_two_boxes());
  Probe& probe = model.probes.front();
  EXPECT_NEAR(far_side(model, probe).distance, height(model.bodies[probe.body]), 1e-12);
  probe.direction = -probe.direction;
  EXPECT_EQ(far_side(model, probe).distance, INFINITY);  // it pulls
}

TEST(DepthWarnings, TellOfTheScenesDepthAndOfTheBodysThickness) {
  Model model = compile_scene(write_two_boxes());
  Probe& probe = model.probes.front();
  EXPECT_TRUE(warnings_at(model, probe.depth).empty());
  const std::vector<std::string> deeper = warnings_at(model, 1.5 * probe.depth);
  ASSERT_EQ(deeper.size(), 1U);
  EXPECT_THAT(deeper[0],
              AllOf(HasSubstr("probes."), HasSubstr("deeper than the"), HasSubstr("of the scene")));

  probe.depth = 1.0;  // whatever the scene says: the box has an end
  const double thick = height(model.bodies[probe.body]);
  EXPECT_TRUE(warnings_at(model, 0.9 * thick).empty());
  const std::vector<std::string> through = warnings_at(model, 3 * thick);
  ASSERT_EQ(through.size(), 1U);
  EXPECT_THAT(through[0], HasSubstr("than " + model.bodies[probe.body].name + " is thick under it"));
}

TEST(DepthWarnings, AWallThatGivesWayIsNotPressedThrough) {
  Model model = compile_scene(write_two_boxes());
  model.probes.front().depth = 1.0;
  const Loads going_along = press(model, 1e-3, 1).loads;
  Loads still = going_along;
  for (Eigen::VectorXd& load : still.on_body) load.setZero();
  const double depth = 1.001 * far_side(model, model.probes.front()).distance;
  EXPECT_EQ(depth_warnings(model, depth, still).size(), 1U);
  EXPECT_TRUE(depth_warnings(model, depth, going_along).empty());
}

}  // namespace
}  // namespace palpate::sim
