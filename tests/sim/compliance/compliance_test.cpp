#include "sim/compliance/compliance.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

#include "sim/elasticity/static_solve.hpp"
#include "sim/elasticity/stiffness.hpp"
#include "tests/sim/support/box_mesh.hpp"

namespace palpate::sim {
namespace {

using test::box_mesh;
using test::nodes_of;
using test::shaken;
using testing::HasSubstr;
using testing::ThrowsMessage;

const Material kTissue{.young_modulus = 1.0, .poisson_ratio = 0.4};

/// A body, its supports and what touches it.
struct Case {
  TetMesh mesh{};
  std::vector<int> fixed{}, touch{}, drawn{};
};

std::vector<int> without(const std::vector<int>& nodes, const std::vector<int>& removed) {
  std::vector<int> rest;
  std::set_difference(nodes.begin(), nodes.end(), removed.begin(), removed.end(), std::back_inserter(rest));
  return rest;
}

/// An irregular block on a fixed base, touched on top, drawn all round.
Case block() {
  Case c{.mesh = shaken(box_mesh(5, 4, 4, Vec3(0.05, 0.04, 0.04)), 0.0009, 11)};
  c.fixed = c.mesh.node_groups.at("z_min");
  c.touch = c.mesh.node_groups.at("z_max");
  c.drawn = without(nodes_of(c.mesh, {"x_min", "x_max", "y_min", "y_max", "z_max"}), c.fixed);
  return c;
}

Eigen::SparseMatrix<double> stiffness_of(const Case& c) {
  return stiffness(c.mesh, {&kTissue, 1});
}

Compliance condensed(const Case& c) {
  return condense(stiffness_of(c), c.fixed, c.touch, c.drawn);
}

/// Displacements of the whole body under forces on its touchable nodes, by the uncondensed problem.
Eigen::Matrix3Xd whole(const Eigen::SparseMatrix<double>& K, const Case& c, const Eigen::VectorXd& f_T) {
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, K.cols() / 3);
  forces(Eigen::all, c.touch) = f_T.reshaped(3, static_cast<Eigen::Index>(c.touch.size()));
  return static_solve(K, c.fixed, forces);
}

Eigen::VectorXd some_forces(Eigen::Index size) {
  std::mt19937 random(5);
  std::normal_distribution<double> force;
  return Eigen::VectorXd::NullaryExpr(size, [&] { return force(random); });
}

TEST(Condense, IsTheInverseOfTheStiffnessWhenEveryFreeNodeIsTouchable) {
  Case c = block();
  std::vector<int> all(c.mesh.nodes.size());
  std::iota(all.begin(), all.end(), 0);
  c.touch = c.drawn = without(all, c.fixed);
  const Compliance compliance = condensed(c);
  const Eigen::MatrixXd K = stiffness_of(c);
  std::vector<int> unknowns;
  for (const int node : c.touch) unknowns.insert(unknowns.end(), {3 * node, 3 * node + 1, 3 * node + 2});
  const Eigen::MatrixXd product = K(unknowns, unknowns) * compliance.touch_touch;
  EXPECT_LT((product - Eigen::MatrixXd::Identity(product.rows(), product.cols())).cwiseAbs().maxCoeff(),
            1e-11);
  EXPECT_TRUE(compliance.drawn_touch == compliance.touch_touch.cast<float>());
}

TEST(Condense, EqualsTheWholeProblem) {
  const Case c = block();
  const Compliance compliance = condensed(c);
  const Eigen::VectorXd f_T = some_forces(compliance.touch_touch.cols());
  const Eigen::Matrix3Xd u = whole(stiffness_of(c), c, f_T);
  const Eigen::VectorXd u_T = u(Eigen::all, c.touch).reshaped(), u_D = u(Eigen::all, c.drawn).reshaped();
  EXPECT_LT((compliance.touch_touch * f_T - u_T).norm(), 1e-12 * u_T.norm());
  // Single precision: 6e-8 an entry.
  EXPECT_LT((compliance.drawn_touch.cast<double>() * f_T - u_D).norm(), 1e-6 * u_D.norm());
}

/// Few drawn nodes are solved for by rows, many by columns: the same numbers either way.
TEST(Condense, GivesFewAndManyDrawnNodesTheSameRows) {
  Case c = block();
  const Compliance many = condensed(c);
  c.drawn = {c.drawn[0], c.drawn[2], c.touch[5]};
  std::ranges::sort(c.drawn);
  const Compliance few = condensed(c);
  for (std::size_t k = 0; k < few.drawn.size(); ++k) {
    const auto row = std::ranges::find(many.drawn, few.drawn[k]) - many.drawn.begin();
    const Eigen::MatrixXf a = few.drawn_touch.middleRows(static_cast<Eigen::Index>(3 * k), 3);
    EXPECT_LT((a - many.drawn_touch.middleRows(3 * row, 3)).norm(), 1e-6F * a.norm());
  }
}

/// Hard case 17.
TEST(Condense, IsSymmetricPositiveDefinite) {
  const Compliance compliance = condensed(block());
  const Eigen::MatrixXd& C = compliance.touch_touch;
  EXPECT_LE((C - C.transpose()).cwiseAbs().maxCoeff(), 1e-12 * C.cwiseAbs().maxCoeff());
  EXPECT_EQ(C.llt().info(), Eigen::Success);
}

TEST(Condense, KeepsTheOrderOfTheNodes) {
  const Case c = block();
  const Compliance compliance = condensed(c);
  EXPECT_EQ(compliance.touch, c.touch);
  EXPECT_EQ(compliance.drawn, c.drawn);
}

TEST(Condense, ScalesAsOneOverYoungsModulus) {
  const Case c = block();
  const Material hard{.young_modulus = 5e6, .poisson_ratio = kTissue.poisson_ratio};
  const Eigen::MatrixXd C = condensed(c).touch_touch;
  const Compliance of_hard = condense(stiffness(c.mesh, {&hard, 1}), c.fixed, c.touch, c.drawn);
  EXPECT_LT((5e6 * of_hard.touch_touch - C).norm(), 1e-12 * C.norm());
}

/// u [mm] per f [N]: 1000 C, from K in N/mm.
TEST(Condense, IsTheSameInMillimetres) {
  Case c = block();
  const Eigen::MatrixXd C = condensed(c).touch_touch;
  for (Vec3& node : c.mesh.nodes) node *= 1000;
  const Material per_mm2{.young_modulus = 1e-6, .poisson_ratio = 0.4};
  const Compliance in_mm = condense(stiffness(c.mesh, {&per_mm2, 1}), c.fixed, c.touch, c.drawn);
  EXPECT_LT((in_mm.touch_touch / 1000 - C).norm(), 1e-12 * C.norm());
}

/// Hard case 11.
TEST(Condense, DoesNotDependOnTheNumbersOfNodesAndElements) {
  const Case c = block();
  std::mt19937 random(3);
  std::vector<int> new_number(c.mesh.nodes.size());
  std::iota(new_number.begin(), new_number.end(), 0);
  std::shuffle(new_number.begin(), new_number.end(), random);
  Case mixed = c;
  for (std::size_t i = 0; i < new_number.size(); ++i) mixed.mesh.nodes[new_number[i]] = c.mesh.nodes[i];
  for (Tetrahedron& t : mixed.mesh.tetrahedra)
    for (int& node : t) node = new_number[node];
  std::shuffle(mixed.mesh.tetrahedra.begin(), mixed.mesh.tetrahedra.end(), random);
  for (std::vector<int>* nodes : {&mixed.fixed, &mixed.touch, &mixed.drawn}) {
    for (int& node : *nodes) node = new_number[node];
    std::sort(nodes->begin(), nodes->end());
  }
  std::vector<Eigen::Index> unknown;  // of each touch unknown of c, the one of the mixed body
  for (const int node : c.touch) {
    const auto& touch = mixed.touch;
    const auto at = std::ranges::lower_bound(touch, new_number[node]);
    for (int axis = 0; axis < 3; ++axis) unknown.push_back(3 * (at - touch.begin()) + axis);
  }
  const Eigen::MatrixXd C = condensed(c).touch_touch, other = condensed(mixed).touch_touch;
  EXPECT_LT((other(unknown, unknown) - C).norm(), 1e-10 * C.norm());
}

/// Hard case 12: C' = Q C Q^T, block by block.
TEST(Condense, TurnsAndMirrorsWithTheBody) {
  const Case c = block();
  const Eigen::MatrixXd C = condensed(c).touch_touch;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2.0, Vec3(0.3, 1, -1).normalized()).toRotationMatrix();
  const Eigen::Matrix3d mirror = Vec3(1, 1, -1).asDiagonal().toDenseMatrix();
  for (const Eigen::Matrix3d& Q : {turn, mirror}) {
    Case moved = c;
    for (Vec3& node : moved.mesh.nodes) node = Q * node + Vec3(0.1, -0.2, 0.3);
    if (Q.determinant() < 0)
      for (Tetrahedron& t : moved.mesh.tetrahedra) std::swap(t[0], t[1]);
    Eigen::MatrixXd expected(C.rows(), C.cols());
    for (Eigen::Index i = 0; i < C.rows(); i += 3)
      for (Eigen::Index j = 0; j < C.cols(); j += 3)
        expected.block<3, 3>(i, j) = Q * C.block<3, 3>(i, j) * Q.transpose();
    EXPECT_LT((condensed(moved).touch_touch - expected).norm(), 1e-10 * C.norm());
  }
}

/// Hard case 10: what rounding at 1e4 m leaves of the coordinates (1e-10 of a cell) is what C keeps.
TEST(Condense, OfABodyFarAwayKeepsWhatItsCoordinatesKeep) {
  Case c = block();
  const Eigen::MatrixXd C = condensed(c).touch_touch;
  for (Vec3& node : c.mesh.nodes) node += Vec3(1e4, 1e4, -1e4);
  EXPECT_LT((condensed(c).touch_touch - C).norm(), 1e-8 * C.norm());
}

class StiffnessRatio : public testing::TestWithParam<double> {};

/// Hard case 16: the forces are found again from the stiffness, not from the compliance that made the motion.
TEST_P(StiffnessRatio, LeavesNoResidualInTheStiffness) {
  Case c = block();
  c.mesh.region_names = {"nodule"};
  for (std::size_t e = 0; e < c.mesh.region.size(); ++e) c.mesh.region[e] = e % 120 < 30 ? 0 : -1;
  const std::array<Material, 2> materials{kTissue, Material{GetParam(), 0.3}};
  const auto K = stiffness(c.mesh, materials);
  const Compliance compliance = condense(K, c.fixed, c.touch, c.drawn);
  const Eigen::VectorXd f_T = some_forces(compliance.touch_touch.cols());
  const Eigen::Matrix3Xd u = whole(K, c, f_T);
  const Eigen::VectorXd u_T = u(Eigen::all, c.touch).reshaped();
  EXPECT_LT((compliance.touch_touch * f_T - u_T).norm(), 1e-9 * u_T.norm());

  Eigen::Matrix3Xd residual = (K * u.reshaped()).reshaped(3, u.cols());
  const Vec3 support = residual(Eigen::all, c.fixed).rowwise().sum();
  const Eigen::Matrix3Xd f = f_T.reshaped(3, static_cast<Eigen::Index>(c.touch.size()));
  const Vec3 total = f.rowwise().sum();
  EXPECT_LT((support + total).norm(), 1e-6 * f.colwise().norm().sum());
  residual(Eigen::all, c.touch) -= f;
  residual(Eigen::all, c.fixed).setZero();
  EXPECT_LT(residual.cwiseAbs().maxCoeff(), 1e-4 * f.cwiseAbs().maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(HardCases, StiffnessRatio, testing::Values(1e-6, 1e-3, 1e3, 1e6));

/// A node alone, at the centre of a ball-like body held all round: no direction is preferred, by symmetry.
TEST(Condense, OfOneNodeIsThreeByThree) {
  Case c = block();
  c.touch = {c.touch[12]};
  const Compliance alone = condensed(c);
  ASSERT_EQ(alone.touch_touch.rows(), 3);
  const Eigen::VectorXd f_T = Vec3(1, 2, 3);
  const Eigen::Matrix3Xd u = whole(stiffness_of(c), c, f_T);
  EXPECT_LT((alone.touch_touch * f_T - u.col(c.touch[0])).norm(), 1e-12 * u.col(c.touch[0]).norm());
}

TEST(Condense, OfNothingTouchedIsEmpty) {
  Case c = block();
  c.touch.clear();
  const Compliance compliance = condensed(c);
  EXPECT_EQ(compliance.touch_touch.size(), 0);
  EXPECT_EQ(compliance.drawn_touch.rows(), static_cast<Eigen::Index>(3 * c.drawn.size()));
  EXPECT_EQ(compliance.drawn_touch.cols(), 0);
}

/// Blocks past the sizes at which products go by halves and by stripes.
TEST(Condense, EqualsTheWholeProblemWithHundredsOfTouchedNodes) {
  Case c{.mesh = box_mesh(15, 14, 3, Vec3(0.15, 0.14, 0.03))};
  c.fixed = c.mesh.node_groups.at("z_min");
  c.touch = c.drawn = c.mesh.node_groups.at("z_max");
  const Compliance compliance = condensed(c);
  const Eigen::VectorXd f_T = some_forces(compliance.touch_touch.cols());
  const Eigen::VectorXd u_T = whole(stiffness_of(c), c, f_T)(Eigen::all, c.touch).reshaped();
  EXPECT_LT((compliance.touch_touch * f_T - u_T).norm(), 1e-12 * u_T.norm());
}

/// The same input gives the same bits: a replay must.
TEST(Condense, GivesTheSameBitsAgain) {
  const Case c = block();
  const Compliance once = condensed(c), again = condensed(c);
  EXPECT_TRUE(once.touch_touch == again.touch_touch);
  EXPECT_TRUE(once.drawn_touch == again.drawn_touch);
}

TEST(Condense, SaysWhichRankTheSupportsLack) {
  Case c = block();
  c.fixed = {0};
  EXPECT_THAT([&] { condensed(c); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("supports leave 3 of 6 rigid motions free")));
  c.fixed = {0, 1, 2, 3};
  EXPECT_THAT([&] { condensed(c); }, ThrowsMessage<std::invalid_argument>(HasSubstr("they lie on one line")));
}

/// Hard case 22. A million touchable nodes ask for 2e14 bytes.
TEST(Condense, RefusesWhatNoMemoryHolds) {
  std::vector<int> touch(1'000'000);
  std::iota(touch.begin(), touch.end(), 0);
  const Eigen::SparseMatrix<double> K(3'000'000, 3'000'000);
  EXPECT_THAT(
      [&] { condense(K, {}, touch, {}); },
      ThrowsMessage<std::invalid_argument>(HasSubstr(
          "the compliance of 1000000 touchable and 0 drawn nodes needs 216000.0 GB, more than half of")));
}

}  // namespace
}  // namespace palpate::sim
