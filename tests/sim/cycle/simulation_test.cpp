#include "sim/cycle/simulation.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <random>

#include "sim/cycle/press.hpp"
#include "sim/elasticity/static_solve.hpp"
#include "tests/sim/support/on_mesh.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

using test::compile_scene;
using test::on_mesh;
using test::write_two_boxes;

const std::vector<Override> kNone{{"contact.model", "none"}};

class CycleOfEachLaw : public ::testing::TestWithParam<const char*> {};

// The loads of a cycle, put on the uncondensed body, must move its touchable nodes to where the cycle says
// they are.
TEST_P(CycleOfEachLaw, CondensedDeformationIsTheFullOne) {
  const Model model =
      compile_scene(write_two_boxes({.shift = 1.7e-3}), std::vector<Override>{{"contact.model", GetParam()}});
  Simulation simulation(model);
  simulation.step(displaced_by(model, 1.5e-3), kCyclePeriod);
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    const Eigen::Matrix3Xd u = static_solve(stiffness(*body.mesh, body.materials), body.fixed,
                                            on_mesh(body, simulation.loads().on_body[i]));
    const Eigen::VectorXd& found = simulation.displacement(static_cast<int>(i));
    for (std::size_t t = 0; t < body.compliance->touch.size(); ++t)
      EXPECT_LT(
          (u.col(body.compliance->touch[t]) - found.segment<3>(3 * static_cast<Eigen::Index>(t))).norm(),
          1e-11);
  }
}

/// Forces that one pose gives whatever came before: a warm start may move them by the solver's tolerance.
void expect_same(const Vec3& here, const Vec3& there) {
  EXPECT_LE((here - there).norm(), 1e-10 * there.norm());
}

TEST_P(CycleOfEachLaw, GivesTheSameForceWhateverCameBefore) {
  const Model model =
      compile_scene(write_two_boxes({.shift = 1.7e-3}), std::vector<Override>{{"contact.model", GetParam()}});
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> depth(-1e-3, 3e-3), slant(-0.5e-3, 0.5e-3);
  Simulation travelled(model);
  for (int i = 0; i < 50; ++i) {
    const std::vector<ProbeDisplacement> pose{
        {depth(random) * model.probes[0].direction + Vec3(slant(random), slant(random), 0)}};
    Simulation fresh(model);
    const Vec3 here = travelled.step(pose, kCyclePeriod).probe_forces[0];
    const Vec3 first_time = fresh.step(pose, kCyclePeriod).probe_forces[0];
    expect_same(here, first_time);
    const Eigen::VectorXd moved = fresh.displacement(1);
    EXPECT_LE((travelled.displacement(1) - moved).norm(), 1e-9 * moved.norm());
    travelled.reset();
    EXPECT_EQ(travelled.step(pose, kCyclePeriod).probe_forces[0], first_time);
  }
}

// A body that was pressed and is released is where it rests: the other one meets no ghost of it.
TEST_P(CycleOfEachLaw, ABodyThatIsReleasedIsWhereItRests) {
  const Model model = compile_scene(write_two_boxes({.shift = 1.7e-3, .second_probe = true}),
                                    std::vector<Override>{{"contact.model", GetParam()}});
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> depth(-2e-3, 2e-3);
  Simulation travelled(model);
  for (int i = 0; i < 50; ++i) {
    const std::vector<ProbeDisplacement> pose{{depth(random) * model.probes[0].direction},
                                              {depth(random) * model.probes[1].direction}};
    Simulation fresh(model);
    const CycleResult here = travelled.step(pose, kCyclePeriod), first_time = fresh.step(pose, kCyclePeriod);
    for (std::size_t k = 0; k < 2; ++k) expect_same(here.probe_forces[k], first_time.probe_forces[k]);
    ASSERT_EQ(here.pairs.size(), first_time.pairs.size());
    for (std::size_t k = 0; k < here.pairs.size(); ++k)
      EXPECT_EQ(here.pairs[k].active, first_time.pairs[k].active);
    for (int body = 0; body < 2; ++body) {
      const Eigen::VectorXd moved = fresh.displacement(body);
      EXPECT_LE((travelled.displacement(body) - moved).norm(), 1e-9 * moved.norm());
    }
    if (i % 10 == 9)  // nor after a cycle that failed
      travelled.step(std::vector<ProbeDisplacement>{{Vec3(0, NAN, 0)}, {Vec3::Zero()}}, kCyclePeriod);
  }
}

// A pad over the whole touchable underside: what it holds cannot yield, so the other body takes it all, and
// the finger feels it.
TEST(Kuroda, WhatAProbeHoldsLeavesTheWholeWayToTheOtherBody) {
  const std::vector<Override> underside{{"probes.finger.kind", "pad"},
                                        {"probes.finger.radius", "9 mm"},
                                        {"probes.finger.at", "[\"15 mm\", \"15 mm\", \"20.2 mm\"]"}};
  const Model model = compile_scene(write_two_boxes(), underside);
  Simulation simulation(model);
  const CycleResult result = simulation.step(displaced_by(model, 1e-3), kCyclePeriod);
  ASSERT_GT(result.pairs[0].active, 0);
  EXPECT_LT(result.pairs[0].force_on[1].z(), 0.0);  // the lower box is pushed down
  std::vector<Override> without = underside;
  without.push_back({"contact.model", "none"});
  const Model free = compile_scene(write_two_boxes(), without);
  Simulation free_simulation(free);
  EXPECT_GT(result.probe_forces[0].z(),
            1.05 * free_simulation.step(displaced_by(free, 1e-3), kCyclePeriod).probe_forces[0].z());
}

TEST_P(CycleOfEachLaw, FeelsNothingOffTheSkinAndForAPoseThatIsNoNumber) {
  const Model model = compile_scene(write_two_boxes(), std::vector<Override>{{"contact.model", GetParam()}});
  Simulation simulation(model);
  EXPECT_EQ(simulation.step(displaced_by(model, 0.0), kCyclePeriod).probe_forces[0], Vec3(Vec3::Zero()));
  EXPECT_EQ(simulation.step(displaced_by(model, -1e-3), kCyclePeriod).probe_forces[0], Vec3(Vec3::Zero()));
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const CycleResult result =
        simulation.step(std::vector<ProbeDisplacement>{{Vec3(0, bad, 0)}}, kCyclePeriod);
    EXPECT_EQ(result.probe_forces[0], Vec3(Vec3::Zero()));
    EXPECT_EQ(result.solve.stop, Stop::NotFinite);
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, CycleOfEachLaw, ::testing::Values("none", "sibille", "kuroda", "exact"));

TEST(Cycle, WithoutContactTheForceIsLinearInTheDepth) {
  const Model model = compile_scene(write_two_boxes(), kNone);
  const auto curve = press(model, 2e-3, 4).curve;
  for (const PressStep& step : curve)
    EXPECT_NEAR(normal_force(model.probes[0], step.probe_forces[0]) / step.depth,
                normal_force(model.probes[0], curve[0].probe_forces[0]) / curve[0].depth, 1e-9 * 1e6);
}

// A held probe brings the weighted mean of its footprint to where it is, and the body pushes back with what
// was put on it.
TEST(Cycle, ThePadMovesItsWeightedMeanAndFeelsTheSumOfItsLoads) {
  const Model model = compile_scene(write_two_boxes({.probe = "kind = \"pad\"\nradius = \"6 mm\""}), kNone);
  const Probe& probe = model.probes[0];
  ASSERT_GE(probe.nodes.size(), 4u);
  Simulation simulation(model);
  const Vec3 asked(0.3e-3, -0.2e-3, -1e-3);
  const Vec3 felt = simulation.step(std::vector<ProbeDisplacement>{{asked}}, kCyclePeriod).probe_forces[0];
  Vec3 mean = Vec3::Zero(), sum = Vec3::Zero();
  for (std::size_t i = 0; i < probe.nodes.size(); ++i) {
    mean += probe.weights[i] * simulation.displacement(0).segment<3>(3 * probe.nodes[i]);
    sum += simulation.loads().on_body[0].segment<3>(3 * probe.nodes[i]);
  }
  EXPECT_LT((mean - asked).norm(), 1e-12);
  EXPECT_LT((felt + sum).norm(), 1e-9 * felt.norm());
}

TEST(Cycle, AFreeProbeTakesNoForceAcrossItsDirection) {
  const Model model =
      compile_scene(write_two_boxes({.probe = "kind = \"point\"\ntangential = \"free\""}), kNone);
  Simulation simulation(model);
  const Vec3 felt = simulation.step(displaced_by(model, 1e-3), kCyclePeriod).probe_forces[0];
  EXPECT_LT(felt.cross(model.probes[0].direction).norm(), 1e-12 * felt.norm());
  EXPECT_GT(normal_force(model.probes[0], felt), 0.0);
}

// Work of the probe's force along a press is the elastic energy u.f/2 that the body stores (no contact:
// linear).
TEST(Cycle, TheWorkOfAPressIsTheStoredEnergy) {
  const Model model = compile_scene(write_two_boxes(), kNone);
  Simulation simulation(model);
  const double depth = 1e-3;
  const CycleResult result = simulation.step(displaced_by(model, depth), kCyclePeriod);
  const double work = 0.5 * depth * normal_force(model.probes[0], result.probe_forces[0]);
  const double stored = 0.5 * simulation.displacement(0).dot(simulation.loads().on_body[0]);
  EXPECT_NEAR(stored / work, 1.0, 1e-9);
}

}  // namespace
}  // namespace palpate::sim
