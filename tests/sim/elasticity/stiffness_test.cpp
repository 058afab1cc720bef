#include "sim/elasticity/stiffness.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "tests/sim/support/box_mesh.hpp"

namespace palpate::sim {
namespace {

using test::box_mesh;
using test::inner_nodes;
using test::nodes_of;
using test::shaken;
using testing::HasSubstr;
using testing::ThrowsMessage;

const Vec3 kSize(0.04, 0.03, 0.05);  // [m]
const Material kTissue{.young_modulus = 2e5, .poisson_ratio = 0.4};

TetMesh irregular_box() {
  return shaken(box_mesh(4, 3, 5, kSize), 0.0009, 1);
}

Eigen::SparseMatrix<double> stiffness_of(const TetMesh& mesh, const Material& material = kTissue) {
  return stiffness(mesh, {&material, 1});
}

/// u = H x at every node.
Eigen::Matrix3Xd linear_field(const TetMesh& mesh, const Eigen::Matrix3d& gradient) {
  Eigen::Matrix3Xd u(3, static_cast<Eigen::Index>(mesh.nodes.size()));
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    u.col(static_cast<Eigen::Index>(i)) = gradient * mesh.nodes[i];
  return u;
}

Eigen::Matrix3Xd forces(const Eigen::SparseMatrix<double>& K, const Eigen::Matrix3Xd& u) {
  return (K * u.reshaped()).reshaped(3, u.cols());
}

double largest(const Eigen::Matrix3Xd& f) {
  return f.cwiseAbs().maxCoeff();
}

TEST(Stiffness, OfTheUnitTetrahedronIsTheOneComputedByHand) {
  TetMesh mesh{.nodes = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)},
               .tetrahedra = {{0, 1, 2, 3}},
               .region = {-1},
               .region_names = {},
               .node_groups = {},
               .node_tags = {1, 2, 3, 4}};
  // E = 1, nu = 0.25: lambda = mu = 0.4, V = 1/6, gradients (-1,-1,-1), e_x, e_y, e_z. With K_ab = V (lambda
  // g_a g_b^T + mu g_b g_a^T + mu (g_a . g_b) I), times 6/0.4 = 15:
  const Eigen::MatrixXd K = 15 * Eigen::MatrixXd(stiffness_of(mesh, {1.0, 0.25}));
  Eigen::Matrix3d K_00, K_11, K_12;
  K_00 << 5, 2, 2, 2, 5, 2, 2, 2, 5;
  K_11 << 3, 0, 0, 0, 1, 0, 0, 0, 1;
  K_12 << 0, 1, 0, 1, 0, 0, 0, 0, 0;
  EXPECT_LT((K.block<3, 3>(0, 0) - K_00).norm(), 1e-14);
  EXPECT_LT((K.block<3, 3>(3, 3) - K_11).norm(), 1e-14);
  EXPECT_LT((K.block<3, 3>(3, 6) - K_12).norm(), 1e-14);
}

TEST(Stiffness, IsSymmetricToTheLastBit) {
  const Eigen::MatrixXd K = stiffness_of(irregular_box());
  EXPECT_TRUE((K.array() == K.transpose().array()).all());
}

TEST(Stiffness, SixRigidMotionsGiveNoForce) {
  const TetMesh mesh = irregular_box();
  const auto K = stiffness_of(mesh);
  const double entry = K.diagonal().maxCoeff();  // [N/m], times the motion's size: a force to compare with
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 a = Vec3::Unit(axis);
    Eigen::Matrix3d turn;  // small rotation about the axis: u = a x x
    turn << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    const Eigen::Matrix3Xd rotation = linear_field(mesh, turn);
    const Eigen::Matrix3Xd translation = a.replicate(1, rotation.cols());
    EXPECT_LT(largest(forces(K, translation)), 1e-13 * entry);
    EXPECT_LT(largest(forces(K, rotation)), 1e-13 * entry * largest(rotation));
  }
}

TEST(Stiffness, EverythingButARigidMotionCostsEnergy) {
  const Eigen::MatrixXd K = stiffness_of(shaken(box_mesh(2, 2, 2, kSize), 0.001, 3));
  const Eigen::VectorXd energies = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues();
  EXPECT_LT(std::abs(energies[5]), 1e-13 * energies.maxCoeff());
  EXPECT_GT(energies[6], 1e-4 * energies.maxCoeff());
}

/// Under a linear displacement the force on every inner node is zero, and the boundary carries sigma n.
TEST(Stiffness, ConfinedCompressionHasTheConfinedModulus) {
  const TetMesh mesh = irregular_box();
  const double strain = 0.01, E = kTissue.young_modulus, nu = kTissue.poisson_ratio;
  const Eigen::Matrix3Xd f =
      forces(stiffness_of(mesh), linear_field(mesh, Vec3(0, 0, -strain).asDiagonal().toDenseMatrix()));
  const double confined = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu));  // [Pa], Timoshenko & Goodier sec. 6
  const double area = kSize.x() * kSize.y();
  const double press = f(2, nodes_of(mesh, {"z_max"})).sum();
  EXPECT_NEAR(press / (-confined * strain * area), 1.0, 1e-12);
  EXPECT_LT(largest(f(Eigen::all, inner_nodes(mesh))), 1e-12 * std::abs(press));
}

TEST(Stiffness, FreeCompressionHasYoungsModulusAndPoissonsRatio) {
  const TetMesh mesh = irregular_box();
  const double strain = 0.01, nu = kTissue.poisson_ratio;
  const Eigen::Matrix3d bulge = Vec3(nu * strain, nu * strain, -strain).asDiagonal().toDenseMatrix();
  Eigen::Matrix3Xd f = forces(stiffness_of(mesh), linear_field(mesh, bulge));
  const double press = f(2, nodes_of(mesh, {"z_max"})).sum();
  EXPECT_NEAR(press / (-kTissue.young_modulus * strain * kSize.x() * kSize.y()), 1.0, 1e-12);
  // Nothing but the two ends, and those only along z, needs a force.
  f(2, nodes_of(mesh, {"z_min", "z_max"})).setZero();
  EXPECT_LT(largest(f), 1e-12 * std::abs(press));
}

TEST(Stiffness, PureShearHasTheShearModulus) {
  const TetMesh mesh = irregular_box();
  Eigen::Matrix3d shear = Eigen::Matrix3d::Zero();
  shear(0, 2) = 0.01;  // u_x = gamma z
  const Eigen::Matrix3Xd f = forces(stiffness_of(mesh), linear_field(mesh, shear));
  const double G = kTissue.young_modulus / (2 * (1 + kTissue.poisson_ratio));
  const Eigen::VectorXd top = f(0, nodes_of(mesh, {"z_max"})).transpose();
  // A node on the rim carries its share of the side faces' traction as well, along z only: f_x is the top's.
  EXPECT_NEAR(top.sum() / (G * 0.01 * kSize.x() * kSize.y()), 1.0, 1e-12);
}

TEST(Stiffness, ScalesWithYoungsModulus) {
  const TetMesh mesh = irregular_box();
  const auto soft = stiffness_of(mesh, {1.0, 0.4}), hard = stiffness_of(mesh, {5e6, 0.4});
  EXPECT_LT((hard - 5e6 * soft).norm(), 1e-15 * hard.norm());
}

TEST(Stiffness, IsTheSameInMillimetres) {
  const TetMesh metres = irregular_box();
  TetMesh millimetres = metres;
  for (Vec3& node : millimetres.nodes) node *= 1000;
  // E [N/mm^2] = 1e-6 E [Pa], and so K [N/mm] = 1e-3 K [N/m].
  const auto K = stiffness_of(metres), in_mm = stiffness_of(millimetres, {kTissue.young_modulus * 1e-6, 0.4});
  EXPECT_LT((1000 * in_mm - K).norm(), 1e-14 * K.norm());
}

/// Hard case 10. Moving the body costs the digits of its coordinates; from there on nothing may be lost.
TEST(Stiffness, FarFromTheOriginLosesOnlyTheDigitsOfTheCoordinates) {
  const Vec3 far(1e4, -1e4, 1e4);
  TetMesh away = irregular_box(), back = away;
  for (std::size_t i = 0; i < away.nodes.size(); ++i) {
    away.nodes[i] += far;
    back.nodes[i] = away.nodes[i] - far;  // exact: what the rounded coordinates say
  }
  const auto K_away = stiffness_of(away), K_back = stiffness_of(back), K = stiffness_of(irregular_box());
  EXPECT_LT((K_away - K_back).norm(), 1e-14 * K.norm());
  // Spacing of doubles at 1e4 m is 1.8e-12 m, cells are 0.01 m: 2e-10, times the shape's condition.
  EXPECT_LT((K_away - K).norm(), 1e-8 * K.norm());
}

/// Hard case 11.
TEST(Stiffness, DoesNotDependOnTheOrderOfElementsOrOfTheirNodes) {
  const TetMesh mesh = irregular_box();
  TetMesh mixed = mesh;
  std::mt19937 random(7);
  std::shuffle(mixed.tetrahedra.begin(), mixed.tetrahedra.end(), random);
  for (Tetrahedron& t : mixed.tetrahedra) t = {t[2], t[0], t[1], t[3]};  // even: the volume stays positive
  const auto K = stiffness_of(mesh);
  EXPECT_LT((stiffness_of(mixed) - K).norm(), 1e-10 * K.norm());
}

/// Hard case 12: K' = Q K Q^T for a body turned or mirrored by Q.
TEST(Stiffness, TurnsAndMirrorsWithTheBody) {
  const TetMesh mesh = irregular_box();
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  const Eigen::Matrix3d mirror = Vec3(-1, 1, 1).asDiagonal().toDenseMatrix();
  const Eigen::MatrixXd K = stiffness_of(mesh);
  for (const Eigen::Matrix3d& Q : {turn, mirror, Eigen::Matrix3d(turn * mirror)}) {
    TetMesh moved = mesh;
    for (Vec3& node : moved.nodes) node = Q * node;
    if (Q.determinant() < 0)
      for (Tetrahedron& t : moved.tetrahedra) std::swap(t[0], t[1]);
    Eigen::MatrixXd expected(K.rows(), K.cols());
    for (Eigen::Index i = 0; i < K.rows(); i += 3)
      for (Eigen::Index j = 0; j < K.cols(); j += 3)
        expected.block<3, 3>(i, j) = Q * K.block<3, 3>(i, j) * Q.transpose();
    EXPECT_LT((Eigen::MatrixXd(stiffness_of(moved)) - expected).norm(), 1e-13 * K.norm());
  }
}

TEST(Stiffness, TakesEachRegionsMaterial) {
  TetMesh mesh = irregular_box();
  mesh.region_names = {"nodule"};
  for (std::size_t e = 0; e < mesh.region.size(); ++e) mesh.region[e] = e < 30 ? 0 : -1;
  const std::array<Material, 2> both{{{1.0, 0.4}, {20.0, 0.3}}};
  TetMesh nodule = mesh, rest = mesh;
  nodule.tetrahedra.erase(nodule.tetrahedra.begin() + 30, nodule.tetrahedra.end());
  rest.tetrahedra.erase(rest.tetrahedra.begin(), rest.tetrahedra.begin() + 30);
  for (TetMesh* part : {&nodule, &rest}) {
    part->region.assign(part->tetrahedra.size(), -1);
    part->region_names.clear();
  }
  const Eigen::MatrixXd parts =
      Eigen::MatrixXd(stiffness_of(nodule, both[1])) + Eigen::MatrixXd(stiffness_of(rest, both[0]));
  EXPECT_LT((Eigen::MatrixXd(stiffness(mesh, both)) - parts).norm(), 1e-15 * parts.norm());
}

struct BadMaterial {
  Material material;
  const char* message;
};

class StiffnessRefuses : public testing::TestWithParam<BadMaterial> {};

TEST_P(StiffnessRefuses, MaterialOutsideItsBounds) {
  const TetMesh mesh = irregular_box();
  EXPECT_THAT([&] { stiffness_of(mesh, GetParam().material); },
              ThrowsMessage<std::invalid_argument>(HasSubstr(GetParam().message)));
}

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
INSTANTIATE_TEST_SUITE_P(
    Bounds, StiffnessRefuses,
    testing::Values(BadMaterial{{0.0, 0.3}, "young_modulus of the body = 0 Pa, must be finite and > 0"},
                    BadMaterial{{-1.0, 0.3}, "young_modulus of the body = -1 Pa"},
                    BadMaterial{{kNaN, 0.3}, "young_modulus of the body = nan Pa"},
                    BadMaterial{{kInfinity, 0.3}, "young_modulus of the body = inf Pa"},
                    BadMaterial{{1.0, 0.5}, "poisson_ratio of the body = 0.5, must be > -1 and < 0.5"},
                    BadMaterial{{1.0, -1.0}, "poisson_ratio of the body = -1"},
                    BadMaterial{{1.0, kNaN}, "poisson_ratio of the body = nan"}));

TEST(Stiffness, NamesTheRegionWithTheBadMaterial) {
  TetMesh mesh = irregular_box();
  mesh.region_names = {"nodule"};
  const std::array<Material, 2> materials{{{1.0, 0.4}, {1.0, 0.7}}};
  EXPECT_THAT([&] { stiffness(mesh, materials); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("poisson_ratio of region 'nodule' = 0.7")));
  EXPECT_THAT([&] { stiffness_of(mesh); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("1 materials given, must be 2")));
}

TEST(Stiffness, NamesTheTetrahedronThatIsInsideOut) {
  TetMesh mesh = irregular_box();
  std::swap(mesh.tetrahedra[17][0], mesh.tetrahedra[17][1]);
  EXPECT_THAT([&] { stiffness_of(mesh); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("tetrahedron 17 ")));
}

}  // namespace
}  // namespace palpate::sim
