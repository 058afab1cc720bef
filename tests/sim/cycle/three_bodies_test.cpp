// Three slabs in a row, each held at its sides: "upper" is pressed into "middle", and that into "lower". The lower one is
// the upper one turned inside out through the middle's centre, which turns the middle into itself.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "sim/contact/exact/exact.hpp"
#include "sim/cycle/press.hpp"
#include "sim/elasticity/static_solve.hpp"
#include "sim/mesh/write_msh.hpp"
#include "tests/sim/support/body_table.hpp"
#include "tests/sim/support/box_mesh.hpp"
#include "tests/sim/support/on_mesh.hpp"
#include "tests/sim/support/two_boxes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::sim {
namespace {

using test::compile_scene;
using test::on_mesh;

constexpr int kCells = 8;  // along x and y: nodes of neighbours face each other
constexpr double kSide = 30e-3, kGap = 0.1e-3, kThick = 8e-3, kThin = 5e-3;  // [m]

/// The slab with its middle at z, and groups of its sides and of both its faces.
TetMesh slab(int layers, double thickness, double z) {
  TetMesh mesh = test::box_mesh(kCells, kCells, layers, Vec3(kSide, kSide, thickness));
  mesh.node_groups["sides"] = test::nodes_of(mesh, {"x_min", "x_max", "y_min", "y_max"});
  mesh.node_groups["faces"] = test::nodes_of(mesh, {"z_min", "z_max"});
  for (Vec3& node : mesh.nodes) node += Vec3(-kSide / 2, -kSide / 2, z - thickness / 2);
  return mesh;
}

TetMesh inside_out(TetMesh mesh) {
  for (Vec3& node : mesh.nodes) node = -node;
  for (Tetrahedron& tetrahedron : mesh.tetrahedra) std::swap(tetrahedron[2], tetrahedron[3]);
  return mesh;
}

std::string probe(const char* name, const char* body, const Vec3& at, int direction) {
  return fmt::format(
      "[probes.{}]\nbody = \"{}\"\nkind = \"point\"\nat = [\"{} m\", \"{} m\", \"{} m\"]\n"
      "direction = [0, 0, {}]\ndepth = \"3 mm\"\n",
      name, body, at.x(), at.y(), at.z(), direction);
}

struct Slabs {
  Vec3 shift = Vec3::Zero();  // of the upper slab, and of the lower one back [m]
  double bumps = 0.0;         // of the middle slab's faces, the share of its thickness
  bool with_far = false;      // a fourth body, a metre away, that the others may touch
};

Model three_slabs(const std::string& law, const Slabs& slabs = {}) {
  const palpate::test::TemporaryFolder folder;
  TetMesh upper = slab(2, kThin, (kThick + kThin) / 2 + kGap);
  for (Vec3& node : upper.nodes) node += slabs.shift;
  write_msh(folder / "upper.msh", upper);
  TetMesh middle = slab(4, kThick, 0.0);
  for (Vec3& node : middle.nodes) node.z() *= 1.0 + slabs.bumps * std::cos(211 * node.x() + 97 * node.y());
  write_msh(folder / "middle.msh", middle);
  write_msh(folder / "lower.msh", inside_out(upper));
  write_msh(folder / "far.msh", slab(2, kThin, 0.0));
  std::ofstream scene(folder / "scene.toml");
  scene << "name = \"three slabs\"\n"
        << test::body_table("upper", "sides", "z_min") << test::body_table("middle", "sides", "faces")
        << test::body_table("lower", "sides", "z_min");
  if (slabs.with_far)
    scene << test::body_table("far", "sides", "faces") << "offset = [\"0 m\", \"0 m\", \"-1 m\"]\n";
  scene << "[contact]\ntouch = [[\"upper\", \"middle\"], [\"middle\", \"lower\"]"
        << (slabs.with_far ? ", [\"upper\", \"far\"], [\"far\", \"middle\"]" : "") << "]\nmodel = \"" << law
        << "\"\n"
        << probe("finger", "upper", slabs.shift + Vec3(0, 0, 20e-3), -1)
        << probe("thumb", "lower", -slabs.shift - Vec3(0, 0, 20e-3), 1);
  scene.close();
  return compile_scene(folder / "scene.toml");
}

std::vector<ProbeDisplacement> pressed(double finger, double thumb) {
  return {{Vec3(0, 0, -finger)}, {Vec3(0, 0, thumb)}};
}

Vec3 sum_of(const Eigen::VectorXd& loads) {
  return Eigen::Map<const Eigen::Matrix3Xd>(loads.data(), 3, loads.size() / 3).rowwise().sum();
}

class ThreeSlabs : public testing::TestWithParam<const char*> {};

// What finger and thumb do from either side is the same, turned inside out. No node is over an edge and no two polygons
// at a node face alike: where they do, kuroda takes the first, which the mesh's order decides.
TEST_P(ThreeSlabs, PressedFromBothSidesAlikeAnswerAlike) {
  const Model model = three_slabs(GetParam(), {.shift = Vec3(1.7e-3, 0.6e-3, 0), .bumps = 0.01});
  Simulation simulation(model);
  const CycleResult result = simulation.step(pressed(2e-3, 2e-3), kCyclePeriod);
  ASSERT_EQ(result.solve.stop, Stop::Converged);
  EXPECT_GT(result.pairs[0].active, 0);
  EXPECT_EQ(result.pairs[0].active, result.pairs[1].active);
  const double scale = result.probe_forces[0].norm();
  EXPECT_LE((result.probe_forces[0] + result.probe_forces[1]).norm(), 1e-9 * scale);
  EXPECT_LE((result.pairs[0].force_on[0] + result.pairs[1].force_on[1]).norm(), 1e-9 * scale);
  const auto whole = whole_bodies(model, simulation.loads());
  // Of some 1e-3 m: condensed by one algorithm in another order.
  EXPECT_LE((whole[0].displacement + whole[2].displacement).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LE((whole[1].displacement + whole[1].displacement.rowwise().reverse()).cwiseAbs().maxCoeff(), 1e-12);
}

// To the last bit: what cannot be reached is not there. (Two more bodies' pairs come last.)
TEST_P(ThreeSlabs, DoNotFeelABodyFarAway) {
  const Model model = three_slabs(GetParam()), more = three_slabs(GetParam(), {.with_far = true});
  Simulation here(model), beside(more);
  for (const double depth : {0.5e-3, 1e-3, 2e-3, 3e-3, 1.5e-3}) {
    const CycleResult few = here.step(pressed(depth, depth / 2), kCyclePeriod);
    const CycleResult many = beside.step(pressed(depth, depth / 2), kCyclePeriod);
    ASSERT_EQ(few.solve.stop, Stop::Converged);
    for (std::size_t probe = 0; probe < 2; ++probe)
      EXPECT_EQ(few.probe_forces[probe], many.probe_forces[probe]) << depth;
    for (std::size_t body = 0; body < 3; ++body)
      EXPECT_EQ(here.loads().on_body[body], beside.loads().on_body[body]) << depth;
    EXPECT_EQ(many.pairs[2].active, 0);
    EXPECT_TRUE(beside.loads().on_body[3].isZero(0.0));
  }
}

// What cannot be reached costs nothing: its contacts are not summed up.
TEST(ThreeSlabsExact, DoNotLookAtABodyFarAway) {
  const Model model = three_slabs("exact"), more = three_slabs("exact", {.with_far = true});
  Simulation here(model), beside(more);
  const auto looked_at = [](const Simulation& simulation) {
    return static_cast<const ExactScratch&>(*simulation.law_scratch()).solve.looked_at();
  };
  const auto& far = static_cast<const ExactScratch&>(*beside.law_scratch());
  const auto& near = static_cast<const ExactScratch&>(*here.law_scratch());
  ASSERT_EQ(far.pairs.size(), 2 * near.pairs.size());
  for (const double depth : {0.5e-3, 1e-3, 2e-3, 3e-3}) {
    here.step(pressed(depth, depth / 2), kCyclePeriod);
    beside.step(pressed(depth, depth / 2), kCyclePeriod);
    EXPECT_EQ(looked_at(here), looked_at(beside)) << depth;
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, ThreeSlabs, testing::Values("kuroda", "exact"),
                         [](const auto& law) { return std::string(law.param); });

// Exact contact is one problem over all bodies: the press goes through the middle slab.
TEST(ThreeSlabsExact, PassAPressOn) {
  const Model model = three_slabs("exact"), alone = without_contact(model);
  Simulation simulation(model), free(alone);
  const CycleResult result = simulation.step(pressed(3e-3, 0), kCyclePeriod);
  ASSERT_EQ(result.solve.stop, Stop::Converged);
  for (const PairSummary& pair : result.pairs) {
    EXPECT_GT(pair.active, 0);
    EXPECT_GT(pair.force_on[0].z(), 0.0);
    EXPECT_LT(pair.force_on[1].z(), 0.0);
  }
  EXPECT_EQ(result.probe_forces[1], Vec3::Zero());  // off the skin
  EXPECT_GT(result.probe_forces[0].z(), 1.1 * free.step(pressed(3e-3, 0), kCyclePeriod).probe_forces[0].z());
}

// The paper's law is one pass from where the probes alone put the bodies: what only the middle slab would touch once it
// is pushed is not found (docs/method.md).
TEST(ThreeSlabsKuroda, PassAPressOnToTheNextSlabOnly) {
  const Model model = three_slabs("kuroda");
  Simulation simulation(model);
  const CycleResult result = simulation.step(pressed(3e-3, 0), kCyclePeriod);
  EXPECT_GT(result.pairs[0].active, 0);
  EXPECT_EQ(result.pairs[1].active, 0);
  EXPECT_LT(sum_of(simulation.loads().on_body[1]).z(), 0.0);
  EXPECT_TRUE(simulation.loads().on_body[2].isZero(0.0));
}

// The conditions of contact, node by node, with displacements of the uncondensed stiffness: each node of a face stands
// opposite one of the other body's, so that their gap is the one at rest and what they have moved along z.
TEST(ThreeSlabsExact, KeepApartAndPushOnlyWhereTheyTouch) {
  const Model model = three_slabs("exact");
  Simulation simulation(model);
  const CycleResult result = simulation.step(pressed(3e-3, 1e-3), kCyclePeriod);
  ASSERT_EQ(result.solve.stop, Stop::Converged);
  std::vector<Eigen::Matrix3Xd> u, f;
  for (std::size_t i = 0; i < 3; ++i) {
    const Body& body = model.bodies[i];
    f.push_back(on_mesh(body, simulation.loads().on_body[i]));
    u.push_back(static_solve(stiffness(*body.mesh, body.materials), body.fixed, f.back()));
  }
  const double largest = f[0].cwiseAbs().maxCoeff();
  constexpr int kFace = (kCells + 1) * (kCells + 1);
  const int last = static_cast<int>(model.bodies[1].mesh->nodes.size()) - 1;
  int closed = 0;
  for (int node = 0; node < kFace; ++node) {
    const int top = last - (kFace - 1) + node;  // of the middle, under the upper's node
    const int below = kFace - 1 - node;         // of the lower, under the middle's node
    const std::array<double, 2> gaps{kGap + u[0](2, node) - u[1](2, top),
                                     kGap + u[1](2, node) - u[2](2, below)};
    const std::array<double, 2> pushes{f[0](2, node), f[1](2, node)};  // upwards, on the upper one of two
    for (std::size_t pair = 0; pair < 2; ++pair) {
      // 1e-8 of the largest, as K is factorised and condensed by other roundings.
      EXPECT_GE(gaps[pair], -1e-8 * 3e-3);
      EXPECT_GE(pushes[pair], -1e-8 * largest);
      EXPECT_LE(std::min(gaps[pair] / 3e-3, pushes[pair] / largest), 1e-8) << node;
      closed += pushes[pair] > 1e-6 * largest;
    }
    EXPECT_LE(std::hypot(f[0](0, node), f[0](1, node)), 1e-9 * largest);  // no friction
  }
  EXPECT_GT(closed, 8);
  for (const PairSummary& pair : result.pairs)
    EXPECT_LE((pair.force_on[0] + pair.force_on[1]).norm(), 1e-9 * pair.force_on[0].norm());
  const Vec3 on_middle = result.pairs[0].force_on[1] + result.pairs[1].force_on[0];
  EXPECT_LE((sum_of(simulation.loads().on_body[1]) - on_middle).norm(), 1e-9 * largest);
}

}  // namespace
}  // namespace palpate::sim
