#include "sim/elasticity/stress.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/support/box_mesh.hpp"

namespace palpate::sim {
namespace {

const Material kFat{.young_modulus = 3e4, .poisson_ratio = 0.3};
const double kShearModulus = 3e4 / (2 * 1.3);  // G = E / (2 (1 + nu)) [Pa]

/// Von Mises stress of u = H x on an irregular mesh.
Eigen::VectorXd stress_under(const Eigen::Matrix3d& gradient) {
  const TetMesh mesh = test::shaken(test::box_mesh(3, 3, 3, Vec3(0.03, 0.04, 0.05)), 0.001, 5);
  Eigen::Matrix3Xd u(3, static_cast<Eigen::Index>(mesh.nodes.size()));
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    u.col(static_cast<Eigen::Index>(i)) = gradient * mesh.nodes[i];
  return von_mises(mesh, {&kFat, 1}, u);
}

Eigen::Matrix3d diagonal(double x, double y, double z) {
  return Vec3(x, y, z).asDiagonal().toDenseMatrix();
}

TEST(VonMises, IsTheStressItselfUnderPull) {
  const Eigen::VectorXd stress = stress_under(diagonal(0.02, -0.3 * 0.02, -0.3 * 0.02));
  EXPECT_NEAR(stress.minCoeff() / (3e4 * 0.02), 1.0, 1e-12);
  EXPECT_NEAR(stress.maxCoeff() / (3e4 * 0.02), 1.0, 1e-12);
}

TEST(VonMises, IsRootThreeTimesTheShearStress) {
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
  gradient(0, 1) = 0.02;
  const Eigen::VectorXd stress = stress_under(gradient);
  EXPECT_NEAR(stress.minCoeff() / (std::sqrt(3.0) * kShearModulus * 0.02), 1.0, 1e-12);
  EXPECT_NEAR(stress.maxCoeff() / (std::sqrt(3.0) * kShearModulus * 0.02), 1.0, 1e-12);
}

TEST(VonMises, IsZeroUnderPressureAndUnderRotation) {
  EXPECT_LT(stress_under(diagonal(-0.02, -0.02, -0.02)).maxCoeff(), 1e-10 * kShearModulus * 0.02);
  Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
  turn(0, 1) = -0.02, turn(1, 0) = 0.02;
  EXPECT_LT(stress_under(turn).maxCoeff(), 1e-10 * kShearModulus * 0.02);
}

TEST(VonMises, TakesEachRegionsMaterial) {
  TetMesh mesh = test::box_mesh(1, 1, 1, Vec3(1, 1, 1));
  mesh.region_names = {"nodule"};
  mesh.region[2] = 0;
  const std::array<Material, 2> materials{kFat, Material{7 * kFat.young_modulus, 0.3}};
  Eigen::Matrix3Xd u(3, 8);
  for (Eigen::Index i = 0; i < 8; ++i) u.col(i) = Vec3(mesh.nodes[i].y(), 0, 0);
  const Eigen::VectorXd stress = von_mises(mesh, materials, u);
  EXPECT_NEAR(stress[2] / stress[0], 7.0, 1e-12);
}

}  // namespace
}  // namespace palpate::sim
