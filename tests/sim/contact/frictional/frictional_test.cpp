#include "sim/contact/frictional/frictional.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/contact/exact/exact.hpp"
#include "sim/cycle/press.hpp"
#include "tests/sim/support/body_table.hpp"
#include "tests/sim/support/region_boxes.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

using test::body_table;
using test::compile_scene;
using test::region_table;
using test::without_fixed;

/// A small box that a region carries over a larger one.
Model carried(double friction) {
  return compile_scene(test::write_region_boxes(
      without_fixed(body_table("upper", "z_min", "z_min")), body_table("lower", "z_min", "z_max"),
      fmt::format("[contact]\ntouch = [[\"upper\", \"lower\"]]\nmodel = \"exact\"\npairing = \"nodes of "
                  "upper\"\nfriction = {}\n",
                  friction),
      region_table("finger", "upper", "z_max", "20 mm")));
}

/// Two boxes, the upper one held at its sides and pressed by a point.
Model pressed(const char* friction, const char* model = "exact") {
  std::vector<Override> overrides{{"contact.model", model}};
  if (*friction != '\0') overrides.push_back({"contact.friction", friction});
  return compile_scene(test::write_two_boxes({.divisions = 8, .upper_divisions = 7, .shift = 0.4e-3}),
                       overrides);
}

Vec3 step_to(Simulation& simulation, const Vec3& place) {
  const ProbeDisplacement at{place};
  const CycleResult result = simulation.step({&at, 1}, kCyclePeriod);
  EXPECT_EQ(result.solve.stop, Stop::Converged) << place.transpose() << " residual " << result.solve.residual;
  EXPECT_LE(result.solve.residual, 1e-10);
  return result.probe_forces[0];
}

constexpr double kPressed = 0.8e-3;

/// Straight down, then sideways. @return the force at each step of the way sideways
std::vector<Vec3> drag(Simulation& simulation, double way, int steps) {
  for (int i = 1; i <= 40; ++i) step_to(simulation, Vec3(0, 0, -kPressed * i / 40));
  std::vector<Vec3> forces;
  for (int i = 1; i <= steps; ++i)
    forces.push_back(step_to(simulation, Vec3(way * i / steps, 0.3 * way * i / steps, -kPressed)));
  return forces;
}

TEST(Frictional, SticksElasticallyThenSlipsAtItsCoefficient) {
  const Model model = carried(0.3);
  Simulation simulation(model);
  const std::vector<Vec3> forces = drag(simulation, 9e-3, 450);  // over two polygons and more
  const auto ratio = [](const Vec3& force) { return force.head<2>().norm() / std::abs(force.z()); };
  EXPECT_LT(ratio(forces[3]), 0.15);  // 80 um: it sticks, and the tangential force grows with the way
  EXPECT_NEAR(forces[3].head<2>().norm() - forces[1].head<2>().norm(),
              forces[5].head<2>().norm() - forces[3].head<2>().norm(), 0.1 * forces[3].head<2>().norm());
  for (std::size_t i = 200; i < forces.size(); ++i) {
    EXPECT_NEAR(ratio(forces[i]), 0.3, 0.003) << i;
    EXPECT_LT(forces[i].x(), 0.0);  // against the way
  }
  for (const CoulombSolve& solve : {static_cast<const FrictionalScratch&>(*simulation.law_scratch()).solve}) {
    const Eigen::VectorXd& x = solve.forces();
    for (Eigen::Index row = 0; row + 2 < x.size(); row += 3)
      EXPECT_LE(x.segment<2>(row + 1).norm(), 0.3 * x[row] * (1 + 1e-8));
  }
}

TEST(Frictional, TendsToExactAsFrictionVanishes) {
  const Model exact = pressed("", "exact");
  Simulation without(exact);
  const Vec3 free = step_to(without, Vec3(0.2e-3, 0, -1.5e-3));
  double before = std::numeric_limits<double>::infinity();
  for (const char* friction : {"0.1", "0.01", "0.001", "0"}) {
    const Model model = pressed(friction);
    Simulation simulation(model);
    const double apart = (step_to(simulation, Vec3(0.2e-3, 0, -1.5e-3)) - free).norm();
    EXPECT_LT(apart, 0.2 * before) << friction;
    before = apart;
  }
  EXPECT_LT(before, 1e-9 * free.norm());  // at 0
}

TEST(Frictional, ForcesOnBothBodiesAreOpposite) {
  const Model model = carried(0.5);
  Simulation simulation(model);
  for (int i = 1; i <= 60; ++i) {
    const ProbeDisplacement at{Vec3(i * 20e-6, -i * 10e-6, -kPressed * std::min(1.0, i / 20.0)),
                               Vec3(0, 0, i * 2e-3)};
    const CycleResult result = simulation.step({&at, 1}, kCyclePeriod);
    const auto& on = result.pairs[0].force_on;
    ASSERT_LE((on[0] + on[1]).norm(), 1e-9 * on[0].norm());
    ASSERT_LE((result.probe_forces[0] - on[0]).norm(), 1e-9 * on[0].norm());
  }
}

// Round and round in the plane, pressed all along: what is taken out of the hand is what friction takes; no round gives
// energy back, and a round's work grows with the friction.
TEST(Frictional, GainsNoEnergyRoundAClosedPath) {
  double last = 0.0;
  for (const double friction : {0.0, 0.1, 0.4}) {
    const Model model = carried(friction);
    Simulation simulation(model);
    constexpr int kSteps = 240;
    const auto place = [](int i) {
      const double angle = 2 * std::numbers::pi * i / kSteps;
      return Vec3(2e-3 * (std::cos(angle) - 1), 1e-3 * std::sin(2 * angle),
                  -kPressed + 0.2e-3 * std::sin(angle));
    };
    for (int i = 1; i <= 20; ++i) step_to(simulation, place(0) * i / 20.0);
    Vec3 force = step_to(simulation, place(0));
    std::vector<double> work;
    for (int round = 0; round < 3; ++round) {
      double done = 0.0;  // by the hand: against the force that it feels
      for (int i = 1; i <= kSteps; ++i) {
        const Vec3 next = step_to(simulation, place(i));
        done -= 0.5 * (force + next).dot(place(i) - place(i - 1));
        force = next;
      }
      work.push_back(done);
    }
    const double stored = 0.5 * force.norm() * kPressed;
    if (friction == 0.0) {
      // nodes meet one polygon after the other, whose corners give way by different amounts: what that leaves of a
      // round is small
      for (const double done : work) EXPECT_LT(std::abs(done), 1e-2 * stored);
      continue;
    }
    for (const double done : work) EXPECT_GT(done, last);
    EXPECT_NEAR(work[2], work[1], 1e-6 * work[1]);  // a cycle of its own after the first round
    last = work[2];
  }
}

TEST(Frictional, ReplaysTheSameBitsAfterAReset) {
  for (const Model& model : {carried(0.3), pressed("0.3")}) {
    Simulation simulation(model);
    std::vector<Vec3> first;
    for (int round = 0; round < 2; ++round) {
      for (int i = 1; i <= 50; ++i) {
        const Vec3 force =
            step_to(simulation, Vec3(i * 15e-6, i * 5e-6, -kPressed * std::min(1.0, i / 10.0)));
        if (round == 0)
          first.push_back(force);
        else
          ASSERT_EQ(force, first[static_cast<std::size_t>(i - 1)]) << i;
      }
      simulation.reset();
    }
  }
}

TEST(Frictional, RemembersWhatSlipped) {
  const Model model = carried(0.3);
  Simulation there(model), straight(model);
  drag(there, 4e-3, 200);
  for (int i = 200; i >= 0; --i) step_to(there, Vec3(4e-3 * i / 200, 1.2e-3 * i / 200, -kPressed));
  for (int i = 1; i <= 40; ++i) step_to(straight, Vec3(0, 0, -kPressed * i / 40));
  const Vec3 back = step_to(there, Vec3(0, 0, -kPressed)), down = step_to(straight, Vec3(0, 0, -kPressed));
  EXPECT_GT(back.x() - down.x(), 0.2 * std::abs(down.z()));  // it still pulls along the way that it went out
}

TEST(Frictional, IsRefusedWithLawsThatDoNotBalance) {
  for (const char* law : {"kuroda", "sibille"})
    EXPECT_THROW(pressed("0.3", law), std::invalid_argument) << law;
  EXPECT_EQ(pressed("0.3", "none").law->name, "none");
}

}  // namespace
}  // namespace palpate::sim
