#include "sim/model/region.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>

#include "sim/contact/exact/exact.hpp"
#include "sim/cycle/press.hpp"
#include "sim/elasticity/stiffness.hpp"
#include "tests/sim/support/body_table.hpp"
#include "tests/sim/support/region_boxes.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

using test::body_table;
using test::compile_scene;
using test::region_table;
using test::without_fixed;

Model model_of(const std::string& upper, const std::string& lower, const std::string& contact,
               const std::string& probes) {
  return compile_scene(test::write_region_boxes(upper, lower, contact, probes));
}

const std::string kTouch =
    "[contact]\ntouch = [[\"upper\", \"lower\"]]\nmodel = \"exact\"\npairing = \"nodes of upper\"\n";

/// Force and torque that hold the nodes of a region, from K itself.
std::pair<Vec3, Vec3> from_stiffness(const Model& model, int probe, const WholeBody& whole) {
  const Probe& held = model.probes[probe];
  const Body& body = model.bodies[held.body];
  const Eigen::VectorXd forces = stiffness(*body.mesh, body.materials) * whole.displacement.reshaped();
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  for (const int node : held.region->nodes) {
    force += forces.segment<3>(3 * node);
    torque += (body.mesh->nodes[node] - held.at).cross(forces.segment<3>(3 * node));
  }
  return {force, torque};
}

// The upper box stands fixed; its top is moved and turned. What the region feels is what K says of the same motion.
TEST(Region, MovesItsNodesInSixDegreesOfFreedom) {
  const Model model = model_of(body_table("upper", "z_min", "x_min"), body_table("lower", "z_min", "z_max"),
                               "", region_table("finger", "upper", "z_max"));
  Simulation simulation(model);
  const ProbeDisplacement at{.from_rest = Vec3(0.3e-3, -0.2e-3, -0.5e-3), .rotation = Vec3(0.02, -0.05, 0.1)};
  const CycleResult result = simulation.step({&at, 1}, kCyclePeriod);
  ASSERT_EQ(result.solve.stop, Stop::Converged);
  const WholeBody whole = whole_bodies(model, simulation.loads()).front();
  const Eigen::AngleAxisd turn(at.rotation.norm(), at.rotation.normalized());
  for (const int node : model.probes[0].region->nodes) {
    const Vec3 arm = model.bodies[0].mesh->nodes[node] - model.probes[0].at;
    EXPECT_LT((whole.displacement.col(node) - (turn * arm - arm + at.from_rest)).norm(), 1e-15);
  }
  const auto [force, torque] = from_stiffness(model, 0, whole);
  EXPECT_LT((result.probe_forces[0] + force).norm(), 1e-9 * force.norm());
  EXPECT_LT((result.probe_torques[0] + torque).norm(), 1e-9 * torque.norm());
  for (std::size_t i = 0; i < model.bodies[0].compliance->touch.size(); ++i)  // nodes that follow
    EXPECT_LT((simulation.displacement(0).segment<3>(static_cast<Eigen::Index>(3 * i)) -
               whole.displacement.col(model.bodies[0].compliance->touch[i]))
                  .norm(),
              1e-9 * at.from_rest.norm());
}

// Two regions and a point on one body: all forces balance with those of the fixed nodes, and each is what K says.
TEST(Region, SharesItsBodyWithOtherProbes) {
  std::string upper = body_table("upper", "z_min", "y_max");
  upper.replace(upper.find("\"z_min\""), 7,
                "[8, 12, 13]");  // in the middle of the face below, apart from its edges
  const Model model = model_of(
      upper, body_table("lower", "z_min", "z_max"), "",
      region_table("finger", "upper", "x_max") + region_table("thumb", "upper", "x_min") +
          "[probes.tip]\nbody = \"upper\"\nkind = \"point\"\nat = [\"17 mm\", \"17 mm\", \"21.2 mm\"]\ndirection = [0, 0, "
          "-1]\ndepth = \"1 mm\"\n");
  Simulation simulation(model);
  const std::vector<ProbeDisplacement> at{{Vec3(-0.4e-3, 0, 0.1e-3), Vec3(0, 0.02, 0)},
                                          {Vec3(0.2e-3, 0, 0), Vec3(0, 0, -0.03)},
                                          {Vec3(0, 0.1e-3, -0.3e-3)}};
  const CycleResult result = simulation.step(at, kCyclePeriod);
  const WholeBody whole = whole_bodies(model, simulation.loads()).front();
  for (const int probe : {0, 1}) {
    const auto [force, torque] = from_stiffness(model, probe, whole);
    EXPECT_LT((result.probe_forces[probe] + force).norm(), 1e-9 * force.norm()) << probe;
    EXPECT_LT((result.probe_torques[probe] + torque).norm(), 1e-9 * torque.norm()) << probe;
  }
  const int tip = model.bodies[0].compliance->touch[model.probes[2].nodes[0]];
  EXPECT_LT((whole.displacement.col(tip) - at[2].from_rest).norm(), 1e-9 * at[2].from_rest.norm());
}

// Nothing else holds the upper box: it goes along, turned by any angle, without a force.
TEST(Region, MayBeAllThatHoldsItsBody) {
  const Model model =
      model_of(without_fixed(body_table("upper", "z_min", "z_min")), body_table("lower", "z_min", "z_max"),
               kTouch, region_table("finger", "upper", "z_max", "20 mm"));
  Simulation simulation(model);
  const ProbeDisplacement at{.from_rest = Vec3(3e-3, 1e-3, 20e-3), .rotation = Vec3(1.0, -2.0, 0.5)};
  const CycleResult result = simulation.step({&at, 1}, kCyclePeriod);
  EXPECT_EQ(result.probe_forces[0], Vec3::Zero());
  EXPECT_EQ(result.probe_torques[0], Vec3::Zero());
  const WholeBody whole = whole_bodies(model, simulation.loads()).front();
  const Eigen::AngleAxisd turn(at.rotation.norm(), at.rotation.normalized());
  for (std::size_t node = 0; node < model.bodies[0].mesh->nodes.size(); ++node) {
    const Vec3 arm = model.bodies[0].mesh->nodes[node] - model.probes[0].at;
    EXPECT_LT(
        (whole.displacement.col(static_cast<Eigen::Index>(node)) - (turn * arm - arm + at.from_rest)).norm(),
        1e-13);
  }
}

// The same way of one body towards the other, whichever of them goes it.
TEST(Region, PressesAsMuchAsWhenTheOtherBodyComes) {
  const Model model = model_of(
      without_fixed(body_table("upper", "z_min", "z_min")),
      without_fixed(body_table("lower", "z_min", "z_max")), kTouch,
      region_table("finger", "upper", "z_max", "20 mm") + region_table("table", "lower", "z_min", "20 mm"));
  Simulation simulation(model);
  const Vec3 way(2.1e-3, -1.4e-3, -0.7e-3);
  const std::vector<ProbeDisplacement> going{{way}, {Vec3::Zero()}}, coming{{Vec3::Zero()}, {-way}};
  const CycleResult by_upper = simulation.step(going, kCyclePeriod);
  ASSERT_GT(by_upper.pairs[0].active, 3);
  const Vec3 force = by_upper.probe_forces[0];
  EXPECT_LT((force + by_upper.probe_forces[1]).norm(), 1e-9 * force.norm());
  EXPECT_LE(by_upper.solve.residual, 1e-10);
  const CycleResult by_lower = simulation.step(coming, kCyclePeriod);
  EXPECT_LT((by_lower.probe_forces[0] - force).norm(), 1e-9 * force.norm());
  // All turned about the same place by the same angle: forces turn with it.
  const Vec3 about = model.probes[0].at, rotation(0.3, 0.8, -0.4);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(rotation.norm(), rotation.normalized()).toRotationMatrix();
  const Vec3 arm = model.probes[1].at - about;
  const std::vector<ProbeDisplacement> turned{{turn * way, rotation}, {turn * arm - arm, rotation}};
  const CycleResult result = simulation.step(turned, kCyclePeriod);
  EXPECT_LT((result.probe_forces[0] - turn * force).norm(), 1e-9 * force.norm());
}

// Gaps of the rest surfaces where the region has brought them: a stroke over polygon after polygon has no jump beyond
// what the stiffness of all contacts closed explains, and depends on the pose alone.
TEST(Region, StrokesWithoutAJumpAndWithoutMemory) {
  const Model model =
      model_of(without_fixed(body_table("upper", "z_min", "z_min")), body_table("lower", "z_min", "z_max"),
               kTouch, region_table("finger", "upper", "z_max", "20 mm"));
  Simulation stroking(model), fresh(model);
  const double step = 1e-6, depth = 0.6e-3;
  Vec3 before = Vec3::Zero();
  double largest = 0.0, most = 0.0;
  for (int i = 0; i <= 8000; ++i) {
    const ProbeDisplacement at{.from_rest = Vec3(i * step, 0.4 * i * step, -0.2e-3 - depth)};
    const CycleResult result = stroking.step({&at, 1}, kCyclePeriod);
    ASSERT_TRUE(solved(result.solve.stop));
    ASSERT_LE(result.solve.residual, 1e-10);
    const Vec3 force = result.probe_forces[0];
    if (i > 0) largest = std::max(largest, (force - before).norm());
    most = std::max(most, force.norm());
    before = force;
    if (i % 1000 != 0) continue;
    fresh.reset();
    ASSERT_LT((fresh.step({&at, 1}, kCyclePeriod).probe_forces[0] - force).norm(), 1e-9 * most) << i;
  }
  EXPECT_GT(most, 0.1);
  // The force is some `most` at 0.6 mm of depth; a step sideways is a thousandth of that way, and edges of the box meet
  // nodes: fifty times the mean slope is far below a contact that is lost or gained at once.
  EXPECT_LT(largest, 50 * most * step / depth);
}

// Without a reach what faces what stays as it was at rest, and the system is a constant of the scene. Straight down,
// that is the same as what is found anew, to what the lower box's few millimetres let faces change.
TEST(Region, KeepsWhatFacedAtRestWithoutAReach) {
  std::array<Vec3, 2> forces;
  for (std::size_t k = 0; k < 2; ++k) {
    const Model model =
        model_of(without_fixed(body_table("upper", "z_min", "z_min")), body_table("lower", "z_min", "z_max"),
                 kTouch, region_table("finger", "upper", "z_max", k == 0 ? "" : "20 mm"));
    Simulation simulation(model);
    const ProbeDisplacement at{.from_rest = Vec3(0, 0, -1e-3)};
    const CycleResult result = simulation.step({&at, 1}, kCyclePeriod);
    EXPECT_LE(result.solve.residual, 1e-10);
    forces[k] = result.probe_forces[0];
    EXPECT_EQ(static_cast<const ExactScratch&>(*simulation.law_scratch()).carried.has_value(), k == 1);
  }
  EXPECT_GT(forces[0].z(), 0.5);
  // nodes of the upper box over the flat face of the lower one: they face the same places, whatever the depth
  EXPECT_LT((forces[0] - forces[1]).norm(), 1e-9 * forces[0].norm());
}

// A first touch, before any contact is closed, is no exact answer either: the bound must see the contacts that overlap.
TEST(Region, IsFeltWithinTheToleranceFromTheFirstTouch) {
  const auto scene = test::write_region_boxes(without_fixed(body_table("upper", "z_min", "z_min")),
                                              body_table("lower", "z_min", "z_max"), kTouch,
                                              region_table("finger", "upper", "z_max"));
  const Model exact = compile_scene(scene);
  const Model model = compile_scene(scene, std::vector<Override>{{"contact.tolerance", "1 %"}});
  for (const double depth : {0.25e-3, 0.6e-3, 1.5e-3}) {
    Simulation one(exact), other(model);
    const ProbeDisplacement at{.from_rest = Vec3(0, 0, -depth)};
    const Vec3 right = one.step({&at, 1}, kCyclePeriod).probe_forces[0];
    const CycleResult felt = other.step({&at, 1}, kCyclePeriod);
    EXPECT_GT(right.norm(), 0.0);
    EXPECT_LE((felt.probe_forces[0] - right).norm(), felt.solve.force_error_bound + 1e-9 * right.norm());
    EXPECT_LE(felt.solve.force_error_bound, 0.01 * right.norm() * 1.02);
  }
}

// A pad slides over the lower box while the upper one is held where it is: what the pad does to the contacts goes with it.
TEST(Region, FeelsAPadThatSlidesOverTheOtherBody) {
  const Model model = model_of(
      without_fixed(body_table("upper", "z_min", "z_min")), body_table("lower", "z_min", "z_max"), kTouch,
      region_table("finger", "upper", "z_max", "20 mm") +
          "[probes.pad]\nbody = \"lower\"\nkind = \"pad\"\nradius = \"6 mm\"\nreach = \"2 mm\"\nat = [\"30 mm\", "
          "\"30 mm\", \"12 mm\"]\ndirection = [0, 0, -1]\ndepth = \"1 mm\"\n");
  Simulation going(model), fresh(model);
  const Vec3 pressed(0, 0, -0.6e-3);
  const std::vector<ProbeDisplacement> before{{pressed}, {Vec3(0, 0, -0.8e-3)}},
      after{{pressed}, {Vec3(-1.5e-3, -1.2e-3, -0.8e-3)}};
  const Vec3 first = going.step(before, kCyclePeriod).probe_forces[0];
  const Vec3 second = going.step(after, kCyclePeriod).probe_forces[0];
  const Vec3 right = fresh.step(after, kCyclePeriod).probe_forces[0];
  EXPECT_GT((second - first).norm(), 1e-4 * right.norm());
  EXPECT_LT((second - right).norm(), 1e-9 * right.norm());
}

}  // namespace
}  // namespace palpate::sim
