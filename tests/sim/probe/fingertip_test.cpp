#include "sim/probe/fingertip/fingertip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/contact/exact/exact.hpp"
#include "sim/cycle/press.hpp"
#include "tests/sim/contact/exact/lemke.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

Model touched(const char* law, const std::string& more = "") {
  return test::compile_scene(
      test::write_two_boxes({.divisions = 8,
                             .upper_divisions = 12,
                             .probe = "kind = \"fingertip\"\nradius = \"7 mm\"\nreach = \"5 mm\"\n" + more}),
      std::vector<Override>{{"contact.model", law}});
}

Vec3 felt(Simulation& simulation, const Vec3& place) {
  const ProbeDisplacement at{place};
  const CycleResult result = simulation.step({&at, 1}, kCyclePeriod);
  EXPECT_EQ(result.solve.stop, Stop::Converged);
  EXPECT_LE(result.solve.residual, 1e-10);
  return result.probe_forces[0];
}

// No node of the skin is in the sphere, those that are pushed lie on it, and what the skin takes is what is felt.
TEST(Fingertip, LiesOnTheSkinAndOnlyPushes) {
  const Model model = touched("exact");
  Simulation simulation(model);
  const Fingertip& tip = *model.probes[0].tip;
  for (const double depth : {0.3e-3, 1e-3, 2.5e-3}) {
    const Vec3 place(0.7e-3, -0.4e-3, -depth);
    const Vec3 force = felt(simulation, place);
    EXPECT_GT(force.z(), 0.0);
    const Vec3 centre = tip.centre + place;
    const Eigen::VectorXd u = simulation.displacement(0);
    int on_it = 0;
    Vec3 pushed = Vec3::Zero();
    for (const int node : tip.nodes) {
      const Vec3 load = simulation.loads().on_body[0].segment<3>(3 * node);
      FacingPair pair{.node = node};
      if (!meet_tip(model.bodies[0], tip, model.probes[0].direction, centre, pair)) {
        EXPECT_EQ(load, Vec3::Zero());
        continue;
      }
      const double gap = pair.gap + pair.normal.dot(u.segment<3>(3 * node));
      EXPECT_GE(gap, -1e-12);
      EXPECT_GE(load.dot(pair.normal), 0.0);
      if (load.norm() > 0) {
        EXPECT_NEAR(gap, 0.0, 1e-11);
        ++on_it;
      }
      pushed += load;
    }
    EXPECT_GE(on_it, 1);
    EXPECT_LT((pushed + force).norm(), 1e-9 * force.norm());
  }
  EXPECT_EQ(felt(simulation, Vec3(0, 0, 0.1e-3)), Vec3::Zero());  // it sticks to nothing
}

TEST(Fingertip, AgreesWithLemke) {
  const Model model = touched("exact");
  Simulation simulation(model);
  for (const Vec3& place : {Vec3(0, 0, -1.5e-3), Vec3(1.3e-3, 2.2e-3, -2e-3)}) {
    const Vec3 force = felt(simulation, place);
    const auto& scratch = static_cast<const ExactScratch&>(*simulation.law_scratch());
    // the contacts that are there: those beside the sphere have no row
    test::ContactProblem problem;
    std::vector<Eigen::Index> rows;
    for (std::size_t i = 0; i < scratch.gaps.size(); ++i)
      if (scratch.gaps[i] < 1.0) {
        rows.push_back(static_cast<Eigen::Index>(i));
        problem.gaps.push_back(scratch.gaps[i]);
      }
    problem.system.compliance = scratch.system.compliance(rows, rows);
    problem.system.first_of_probe = {0};
    const Eigen::VectorXd x = test::lemke(problem);
    Vec3 exact = Vec3::Zero();
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (const FacingPair& pair = scratch.pairs[static_cast<std::size_t>(rows[i])];
          pair.polygon_body == kRigid)
        exact -= x[static_cast<Eigen::Index>(i)] * pair.normal;
    EXPECT_LT((force - exact).norm(), 1e-8 * exact.norm());
  }
}

// Down and across in steps of a micrometre: no jump at nodes, edges or the edge of the sphere.
TEST(Fingertip, StrokesWithoutAJump) {
  const Model model = touched("exact");
  Simulation simulation(model);
  const double step = 1e-6, depth = 1.5e-3;
  std::vector<Vec3> forces;
  for (int i = -4500; i <= 4500; ++i)
    forces.push_back(felt(simulation, Vec3(i * step, 0.5 * i * step, -depth)));
  double largest = 0.0, most = 0.0;
  for (std::size_t i = 1; i < forces.size(); ++i) {
    largest = std::max(largest, (forces[i] - forces[i - 1]).norm());
    most = std::max(most, forces[i].norm());
  }
  EXPECT_GT(most, 0.1);
  // a node that came or went at once would take a share of the force with it, a tenth of it or more
  EXPECT_LT(largest, 5e-3 * most);
}

// However fast it comes: its force depends on its place alone.
TEST(Fingertip, NeverTunnels) {
  const Model model = touched("exact");
  Simulation slow(model), fast(model);
  for (int i = 1; i <= 100; ++i) felt(slow, Vec3(0, 0, -4e-5 * i));
  const Vec3 deep(0, 0, -4e-3);
  felt(fast, Vec3(0, 0, 50e-3));
  const Vec3 force = felt(fast, deep);  // 54 mm in a cycle, through a wall of 5 mm
  EXPECT_LT((force - felt(slow, deep)).norm(), 1e-9 * force.norm());
  EXPECT_GT(force.z(), felt(slow, Vec3(0, 0, -2e-3)).z());
}

TEST(Fingertip, FeelsTheSameAloneWhetherBodiesMayTouchOrNot) {
  const Model exact = touched("exact"), none = touched("none");
  Simulation one(exact), other(none);
  const Vec3 light(0, 0, -0.05e-3);  // the boxes are 0.2 mm apart
  const Vec3 force = felt(one, light);
  EXPECT_GT(force.z(), 0.0);
  EXPECT_LT((felt(other, light) - force).norm(), 1e-9 * force.norm());
}

TEST(Fingertip, IsRefusedWithWhatCannotLetGo) {
  for (const char* law : {"kuroda", "sibille"}) EXPECT_THROW(touched(law), std::invalid_argument) << law;
  EXPECT_THROW(touched("exact", "tangential = \"free\""), std::invalid_argument);
}

}  // namespace
}  // namespace palpate::sim
