#include "sim/elasticity/finer_inside.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>

#include "sim/compliance/compliance.hpp"
#include "sim/mesh/surface.hpp"
#include "tests/sim/support/box_mesh.hpp"

namespace palpate::sim {
namespace {

const std::vector<Material> kMaterial{{1e6, 0.4}};

TetMesh block() {
  return test::shaken(test::box_mesh(3, 3, 2, Vec3(30e-3, 30e-3, 20e-3)), 0.5e-3, 1);
}

std::vector<int> top_of(const TetMesh& mesh) {
  return mesh.node_groups.at("z_max");
}

TEST(FinerInside, WithoutCutsIsTheMeshsOwnStiffness) {
  const TetMesh mesh = block();
  const FinerBody same = finer_inside(mesh, kMaterial, top_of(mesh), 0);
  EXPECT_EQ(same.nodes.size(), mesh.nodes.size());
  EXPECT_EQ(Eigen::MatrixXd(same.K - stiffness(mesh, kMaterial)).norm(), 0.0);
}

// Any motion that is linear in the place is the same on every mesh of one body: no force inside, and one energy.
TEST(FinerInside, HoldsALinearMotionExactly) {
  const TetMesh mesh = block();
  Eigen::Matrix3d gradient;
  gradient << 1e-2, 2e-3, -1e-3, 4e-3, -2e-2, 5e-3, 0, 3e-3, 1e-2;
  const auto energy = [&](int cuts) {
    const FinerBody body = finer_inside(mesh, kMaterial, top_of(mesh), cuts);
    Eigen::VectorXd u(3 * std::ssize(body.nodes));
    for (std::size_t i = 0; i < body.nodes.size(); ++i)
      u.segment<3>(3 * static_cast<Eigen::Index>(i)) = gradient * body.nodes[i];
    return 0.5 * u.dot(body.K * u);
  };
  const double coarse = energy(0);
  EXPECT_NEAR(energy(1) / coarse, 1.0, 1e-12);
  EXPECT_NEAR(energy(2) / coarse, 1.0, 1e-12);
}

TEST(FinerInside, LeavesRigidMotionsWithoutForce) {
  const TetMesh mesh = block();
  const FinerBody body = finer_inside(mesh, kMaterial, top_of(mesh), 1);
  const Vec3 axis(0.3, -0.8, 0.5);
  Eigen::VectorXd turned(3 * std::ssize(body.nodes));
  for (std::size_t i = 0; i < body.nodes.size(); ++i)
    turned.segment<3>(3 * static_cast<Eigen::Index>(i)) = axis.cross(body.nodes[i]) + Vec3(0.01, 0.02, -0.01);
  const double scale = body.K.diagonal().maxCoeff() * turned.cwiseAbs().maxCoeff();
  EXPECT_LE((body.K * turned).cwiseAbs().maxCoeff(), 1e-11 * scale);
}

// A body with more freedom inside gives way more (the principle of least energy), and less and less more; its touched
// nodes stay as many, and so does what a cycle reads.
TEST(FinerInside, GivesWayMoreAndTheSurfaceStays) {
  const TetMesh mesh = block();
  const std::vector<int> top = top_of(mesh);
  std::vector<double> pressed;
  for (int cuts = 0; cuts <= 2; ++cuts) {
    const FinerBody body = finer_inside(mesh, kMaterial, top, cuts);
    const Compliance compliance = condense(body.K, with_added(body, mesh.node_groups.at("z_min")), top, {});
    ASSERT_EQ(compliance.touch, top);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(compliance.touch_touch.rows());
    for (Eigen::Index i = 2; i < load.size(); i += 3) load[i] = -1.0;
    pressed.push_back(load.dot(compliance.touch_touch * load));
  }
  for (std::size_t i = 1; i < pressed.size(); ++i) EXPECT_GT(pressed[i], pressed[i - 1]);
  EXPECT_LT(pressed[2] - pressed[1], 0.8 * (pressed[1] - pressed[0]));
}

// The face that is held gains the middles of its edges: a grid of n nodes to a side has 2 n - 1 then; no other node is
// held with it.
TEST(FinerInside, HoldsWhatLiesBetweenHeldNodes) {
  const TetMesh mesh = block();
  const std::vector<int> held = mesh.node_groups.at("z_min");
  for (const auto& [cuts, side] : {std::pair(1, 7), std::pair(2, 13)}) {
    const FinerBody body = finer_inside(mesh, kMaterial, top_of(mesh), cuts);
    const std::vector<int> all = with_added(body, held);
    EXPECT_EQ(std::ssize(all), side * side);
    EXPECT_TRUE(std::ranges::is_sorted(all));
    for (const int node : all) EXPECT_LT(std::abs(body.nodes[node].z()), 1e-12);
  }
}

// What is touched follows its corners: no node is added there.
TEST(FinerInside, AddsNoNodeToATouchedFace) {
  const TetMesh mesh = block();
  const FinerBody body = finer_inside(mesh, kMaterial, top_of(mesh), 2);
  const auto on_top =
      std::ranges::count_if(body.nodes, [](const Vec3& node) { return node.z() > 20e-3 - 1e-9; });
  // but on its rim, whose edges belong to the sides as well, there are none either
  EXPECT_EQ(on_top, std::ssize(top_of(mesh)));
}

}  // namespace
}  // namespace palpate::sim
