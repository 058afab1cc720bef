#include "sim/contact/exact/exact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>

#include "sim/cycle/press.hpp"
#include "sim/elasticity/static_solve.hpp"
#include "sim/mesh/write_msh.hpp"
#include "tests/sim/support/body_table.hpp"
#include "tests/sim/support/box_mesh.hpp"
#include "tests/sim/support/on_mesh.hpp"
#include "tests/sim/support/two_boxes.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::sim {
namespace {

using test::compile_scene;
using test::on_mesh;
using test::write_two_boxes;

constexpr const char* kPad = "kind = \"pad\"\nradius = \"6 mm\"";
const std::vector<Override> kExactModel{{"contact.model", "exact"}};

std::vector<Override> with(std::vector<Override> more) {
  more.insert(more.end(), kExactModel.begin(), kExactModel.end());
  return more;
}

std::vector<Override> with_moduli(const std::string& upper, const std::string& lower) {
  return with({{"bodies.upper.young_modulus", upper}, {"bodies.lower.young_modulus", lower}});
}

/// Displacements of the uncondensed bodies under the loads of a cycle, by node of the mesh.
std::vector<Eigen::Matrix3Xd> solved_with_stiffness(const Model& model, const Loads& loads) {
  std::vector<Eigen::Matrix3Xd> displacements;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    displacements.push_back(
        static_solve(stiffness(*body.mesh, body.materials), body.fixed, on_mesh(body, loads.on_body[i])));
  }
  return displacements;
}

double gap_now(const Model& model, const FacingPair& pair, const std::vector<Eigen::Matrix3Xd>& u) {
  const auto at = [&](int body, int touch) -> Vec3 {
    return u[static_cast<std::size_t>(body)].col(model.bodies[body].compliance->touch[touch]);
  };
  Vec3 apart = at(pair.node_body, pair.node);
  for (int k = 0; k < 3; ++k) apart -= pair.weights[k] * at(pair.polygon_body, pair.corners[k]);
  return pair.gap + pair.normal.dot(apart);
}

/// Scaled natural residual with gaps from K, not from C.
double residual_from_stiffness(const Model& model, Simulation& simulation) {
  const auto& scratch = static_cast<const ExactScratch&>(*simulation.law_scratch());
  const auto u = solved_with_stiffness(model, simulation.loads());
  double error = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < scratch.pairs.size(); ++i) {
    const Eigen::Index row = scratch.system.bilateral + static_cast<Eigen::Index>(i);
    const double force = scratch.solve.forces()[row];
    const double slack = gap_now(model, scratch.pairs[i], u) / scratch.system.compliance(row, row);
    error = std::max(error, std::abs(force - std::max(0.0, force - slack)));
    largest = std::max(largest, force);
  }
  return error / largest;
}

struct Ratio {
  const char *upper, *lower;
};

class ExactRatio : public testing::TestWithParam<Ratio> {};

TEST_P(ExactRatio, SolvesContactToAStatedResidualAndBalancesIt) {
  const Model model = compile_scene(write_two_boxes({.shift = 1.7e-3, .probe = kPad}),
                                    with_moduli(GetParam().upper, GetParam().lower));
  Simulation simulation(model);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> depth(0.5e-3, 3e-3), slant(-0.5e-3, 0.5e-3);
  for (int pose = 0; pose < 20; ++pose) {
    const Vec3 there = depth(random) * model.probes[0].direction + Vec3(slant(random), slant(random), 0);
    const CycleResult result = simulation.step(std::vector<ProbeDisplacement>{{there}}, kCyclePeriod);
    ASSERT_EQ(result.solve.stop, Stop::Converged);
    EXPECT_LE(result.solve.residual, 1e-10);
    if (result.pairs[0].active == 0) continue;
    // Factorising K and condensing it round differently, by the condition of K.
    EXPECT_LE(residual_from_stiffness(model, simulation), 1e-8);
    const Vec3 &action = result.pairs[0].force_on[0], &reaction = result.pairs[0].force_on[1];
    EXPECT_LE((action + reaction).norm(), 1e-9 * action.norm());
    // The pad and the supports carry what contact pushes: all loads on the lower box are contact.
    Vec3 sum = Vec3::Zero();
    for (Eigen::Index i = 0; i < simulation.loads().on_body[1].size(); i += 3)
      sum += simulation.loads().on_body[1].segment<3>(i);
    EXPECT_LE((sum - reaction).norm(), 1e-9 * reaction.norm());
  }
}

INSTANTIATE_TEST_SUITE_P(Moduli, ExactRatio,
                         testing::Values(Ratio{"1 MPa", "1 MPa"}, Ratio{"1 MPa", "5 MPa"},
                                         Ratio{"5 MPa", "1 MPa"}, Ratio{"1 MPa", "1 GPa"},
                                         Ratio{"1 MPa", "1000 GPa"}, Ratio{"1000 GPa", "1 MPa"}));

// The force is the slope of the stored energy: nothing is lost in contact without friction. Central differences,
// whose error is of the square of the step away from the depths at which contacts come.
TEST(Exact, ForceIsTheSlopeOfTheStoredEnergy) {
  const Model model = compile_scene(write_two_boxes({.shift = 1.7e-3, .probe = kPad}), kExactModel);
  Simulation simulation(model);
  const auto energy = [&](const Vec3& there) {
    simulation.step(std::vector<ProbeDisplacement>{{there}}, kCyclePeriod);
    double stored = 0.0;
    for (int body = 0; body < 2; ++body)
      stored +=
          0.5 * simulation.displacement(body).dot(simulation.loads().on_body[static_cast<std::size_t>(body)]);
    return stored;
  };
  const double step = 1e-7;
  for (const Vec3& there : {Vec3(0, 0, -1e-3), Vec3(0.2e-3, 0.1e-3, -2e-3), Vec3(-0.4e-3, 0.3e-3, -2.7e-3)}) {
    Vec3 slope;
    for (int k = 0; k < 3; ++k)
      slope[k] = (energy(there + step * Vec3::Unit(k)) - energy(there - step * Vec3::Unit(k))) / (2 * step);
    const Vec3 felt = simulation.step(std::vector<ProbeDisplacement>{{there}}, kCyclePeriod).probe_forces[0];
    EXPECT_LE((felt + slope).norm(), 1e-6 * felt.norm()) << there.transpose();
  }
}

// A body a million times stiffer than the other does not give way: ten times as stiff again is the same, but for the
// millionth that it gives way by, times what a point of contact is softer than a body.
TEST(Exact, AMuchStifferBodyBehavesAsRigid) {
  const auto force = [](const std::string& lower) {
    const Model model = compile_scene(write_two_boxes({.probe = kPad}), with_moduli("1 MPa", lower));
    return press(model, 2e-3, 1).curve[0].probe_forces[0].z();
  };
  const double stiff = force("1000 GPa");
  EXPECT_NEAR(force("10000 GPa") / stiff, 1.0, 1e-5);
  EXPECT_GT(stiff, 1.1 * force("1 MPa"));
}

// The force rises without jumps: a step of a micrometre changes it by no more than the stiffness with every contact
// closed (the millionth beside it is rounding).
TEST(Exact, ForceIsContinuousThroughEveryContact) {
  const Model model = compile_scene(write_two_boxes({.shift = 1.7e-3, .probe = kPad}), kExactModel);
  Simulation simulation(model);
  const auto& scratch = static_cast<const ExactScratch&>(*simulation.law_scratch());
  const Eigen::MatrixXd all =
      scratch.system.compliance + Eigen::MatrixXd(1e-12 * scratch.system.compliance.diagonal().asDiagonal());
  const Eigen::Matrix3d stiffest = all.inverse().topLeftCorner<3, 3>();
  const double steepest = stiffest.operatorNorm(), micrometre = 1e-6;
  Vec3 before = Vec3::Zero();
  for (int i = 1; i <= 3000; ++i) {
    const Vec3 here = simulation.step(displaced_by(model, i * micrometre), kCyclePeriod).probe_forces[0];
    ASSERT_LE((here - before).norm(), 1.000001 * steepest * micrometre) << i;
    before = here;
  }
}

constexpr const char* kMirroredProbes = R"([probes.finger]
body = "upper"
kind = "point"
at = ["15 mm", "15 mm", "6 mm"]
direction = [0, 0, -1]
depth = "2 mm"
[probes.thumb]
body = "lower"
kind = "point"
at = ["15 mm", "15 mm", "-6 mm"]
direction = [0, 0, 1]
depth = "2 mm"
)";

// A body and its mirror image, 0.2 mm apart, pressed together: neither gives way more than the other. Each contact
// is there twice, from either side.
TEST(Exact, MirrorImagesShareTheOverlapEqually) {
  const palpate::test::TemporaryFolder folder;
  TetMesh box = test::box_mesh(8, 8, 3, Vec3(30e-3, 30e-3, 6e-3));
  box.node_groups["sides"] = test::nodes_of(box, {"x_min", "x_max", "y_min", "y_max"});
  for (Vec3& node : box.nodes) node.z() += 0.1e-3;
  write_msh(folder.path() / "upper.msh", box);
  for (Vec3& node : box.nodes) node.z() *= -1;
  for (Tetrahedron& tetrahedron : box.tetrahedra) std::swap(tetrahedron[2], tetrahedron[3]);
  write_msh(folder.path() / "lower.msh", box);
  const std::string upper = test::body_table("upper", "sides", "z_min");
  const std::string lower = test::body_table("lower", "sides", "z_min");
  std::ofstream(folder.path() / "scene.toml")
      << test::two_body_tables(upper, lower, "exact") << kMirroredProbes;
  const Model model = compile_scene(folder.path() / "scene.toml");
  Simulation simulation(model);
  const CycleResult result = simulation.step(displaced_by(model, 1.5e-3), kCyclePeriod);
  EXPECT_GT(result.pairs[0].active, 4);
  EXPECT_LE(result.solve.residual, 1e-10);
  const Vec3 &finger = result.probe_forces[0], &thumb = result.probe_forces[1];
  EXPECT_NEAR(thumb.z() / finger.z(), -1.0, 1e-9);
  const Eigen::VectorXd u = simulation.displacement(0), mirrored = simulation.displacement(1);
  for (Eigen::Index i = 0; i < u.size();
       i += 3) {  // of some 1e-3 m, condensed by one algorithm in another order
    EXPECT_NEAR(mirrored[i], u[i], 1e-12);
    EXPECT_NEAR(mirrored[i + 2], -u[i + 2], 1e-12);
  }
}

// With the nodes of one body alone the other's may enter it, and nothing else changes: the rows are a part of those
// of both.
TEST(Exact, TakesTheNodesOfOneBodyWhereItIsAskedTo) {
  const auto rows_of = [](const char* pairing) {
    const Model model = compile_scene(write_two_boxes({.divisions = 5, .shift = 1.7e-3}),
                                      with({{"contact.pairing", pairing}}));
    return ExactScratch(model).pairs;
  };
  const auto both = rows_of("both"), upper = rows_of("nodes of upper"), lower = rows_of("nodes of lower");
  EXPECT_EQ(both.size(), upper.size() + lower.size());
  EXPECT_FALSE(upper.empty() || lower.empty());
  EXPECT_TRUE(std::ranges::all_of(upper, [](const FacingPair& pair) { return pair.node_body == 0; }));
  EXPECT_TRUE(std::ranges::all_of(lower, [](const FacingPair& pair) { return pair.node_body == 1; }));
}

// A body that lies free in the hollow of a tube is behind the tube's outer wall, which may be touched, and not within
// it: nothing holds it there, and nothing pushes.
TEST(Exact, WhatLiesBeyondAWallIsNotPushedThroughIt) {
  const auto scene =
      std::filesystem::path(palpate::test::source_folder()) / "data/scenes/rectal-palpation.toml";
  for (const char* scale : {"0.2", "0.05"}) {
    const Model model = compile_scene(scene, with({{"bodies.prostate.scale", scale}}));
    const Press pressed = press(model, 1e-6, 1);
    EXPECT_EQ(pressed.curve[0].pairs[0].active, 0);
    EXPECT_LT(pressed.curve[0].probe_forces[0].norm(), 0.01);
  }
}

TEST(Exact, APairThatIsOutOfReachPushesNothing) {
  const Model model = compile_scene(write_two_boxes({.gap = 8e-3}), kExactModel);
  const Press pressed = press(model, 2e-3, 2);
  EXPECT_EQ(pressed.curve[1].pairs[0].active, 0);
  const Model free =
      compile_scene(write_two_boxes({.gap = 8e-3}), std::vector<Override>{{"contact.model", "none"}});
  EXPECT_EQ(pressed.curve[1].probe_forces[0], press(free, 2e-3, 2).curve[1].probe_forces[0]);
}

}  // namespace
}  // namespace palpate::sim
