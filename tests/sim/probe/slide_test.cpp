#include "sim/probe/slide/slide.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/cycle/press.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

Model stroked(const char* law, const char* more,
              const std::string& pad = "kind = \"pad\"\nradius = \"6 mm\"\n") {
  return test::compile_scene(
      test::write_two_boxes({.divisions = 8, .upper_divisions = 12, .probe = pad + more}),
      std::vector<Override>{{"contact.model", law}});
}

constexpr const char* kReach = "reach = \"4 mm\"";

TEST(Slide, IsThePadWhereItStandsAtANode) {
  for (const char* law : {"none", "exact", "kuroda", "sibille"}) {
    const Model still = stroked(law, ""), sliding = stroked(law, kReach);
    ASSERT_FALSE(sliding.probes[0].slide.knots.empty());
    Simulation one(still), other(sliding);
    const ProbeDisplacement at{Vec3(0, 0, -0.8e-3)};
    const Vec3 force = one.step({&at, 1}, kCyclePeriod).probe_forces[0];
    EXPECT_GT(force.norm(), 0.1);
    // On flat faces kuroda's ties follow the nodes' numbers, which go by all that may be touched.
    const double tolerance = std::string_view(law) == "kuroda" ? 1e-3 : 1e-9;
    EXPECT_LT((other.step({&at, 1}, kCyclePeriod).probe_forces[0] - force).norm(), tolerance * force.norm())
        << law;
  }
}

// One cell of the mesh is 2.5 mm: the way crosses nodes, edges and polygons. What a pad presses changes slowly along it;
// a node that came into the footprint with a weight would be seen as a jump.
TEST(Slide, HasNoJumpAcrossNodesAndPolygons) {
  const Model model = stroked("exact", kReach);
  Simulation simulation(model);
  const double step = 1e-6;
  std::vector<Vec3> forces;
  for (int i = -3500; i <= 3500; ++i) {
    const ProbeDisplacement at{Vec3(i * step, 0.3 * i * step, -0.8e-3)};
    forces.emplace_back(simulation.step({&at, 1}, kCyclePeriod).probe_forces[0]);
  }
  double largest = 0.0, least = forces[0].norm(), most = least;
  for (std::size_t i = 1; i < forces.size(); ++i) {
    largest = std::max(largest, (forces[i] - forces[i - 1]).norm());
    least = std::min(least, forces[i].norm());
    most = std::max(most, forces[i].norm());
  }
  EXPECT_GT(least, 0.5 * most);           // it is on the surface all along
  EXPECT_LT(largest, 2e-3 * most);        // 7000 steps
  EXPECT_GT(most - least, 10 * largest);  // and it does change
}

// The stroke has no memory: there and back is the same.
TEST(Slide, DependsOnThePoseAlone) {
  for (const char* law : {"none", "exact", "kuroda"}) {
    const Model model = stroked(law, kReach);
    Simulation going(model), fresh(model);
    for (const double x : {-3e-3, 1.2e-3, 0.1e-3, 2.9e-3, 1.2e-3}) {
      const ProbeDisplacement at{Vec3(x, -0.5 * x, -0.7e-3)};
      const Vec3 force = going.step({&at, 1}, kCyclePeriod).probe_forces[0];
      fresh.reset();
      EXPECT_LT((fresh.step({&at, 1}, kCyclePeriod).probe_forces[0] - force).norm(), 1e-9 * force.norm())
          << law;
    }
  }
}

TEST(Slide, HoldsTheMeanOfItsNodesWhereItIs) {
  const Model model = stroked("exact", kReach);
  Simulation simulation(model);
  const ProbeDisplacement at{Vec3(1.1e-3, 0.7e-3, -0.9e-3)};
  const CycleResult result = simulation.step({&at, 1}, kCyclePeriod);
  const Probe& probe = model.probes[0];
  const ProbeRow& row = simulation.free_state().probes[0];
  Vec3 mean = Vec3::Zero(), pushed = Vec3::Zero();
  const Eigen::VectorXd u = simulation.displacement(0);
  for (std::size_t i = 0; i < probe.nodes.size(); ++i)
    mean += row.weights[static_cast<Eigen::Index>(i)] * u.segment<3>(3 * probe.nodes[i]);
  EXPECT_NEAR(row.weights.sum(), 1.0, 1e-12);
  EXPECT_LT((mean - Vec3(0, 0, -0.9e-3)).norm(), 1e-9 * 0.9e-3);
  for (const Eigen::VectorXd& loads : {simulation.loads().on_body[0]})
    for (Eigen::Index i = 0; i < loads.size(); i += 3) pushed += loads.segment<3>(i);
  // the probe's and the contact's forces on the upper body
  EXPECT_LT((pushed + result.probe_forces[0] - result.pairs[0].force_on[0]).norm(), 1e-9 * pushed.norm());
}

}  // namespace
}  // namespace palpate::sim
