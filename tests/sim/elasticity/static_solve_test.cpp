#include "sim/elasticity/static_solve.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "sim/elasticity/stiffness.hpp"
#include "sim/elasticity/stress.hpp"
#include "tests/sim/support/box_mesh.hpp"

namespace palpate::sim {
namespace {

using test::box_mesh;
using test::inner_nodes;
using test::nodes_of;
using test::shaken;

Eigen::Matrix3Xd times(const Eigen::SparseMatrix<double>& K, const Eigen::Matrix3Xd& u) {
  return (K * u.reshaped()).reshaped(3, u.cols());
}

class PatchTest : public testing::TestWithParam<unsigned> {};

/// A linear displacement on the boundary of an irregular mesh goes through it unchanged, with one stress
/// everywhere [Irons & Razzaque 1972]. The boundary's displacement is turned into forces: u = g + w, where g
/// is the field on the boundary and zero inside, and K_ii w_i = -(K g)_i.
TEST_P(PatchTest, LinearFieldPassesToRoundOff) {
  std::mt19937 random(GetParam());
  std::uniform_real_distribution<double> entry(-0.1, 0.1);
  const TetMesh mesh = shaken(box_mesh(5, 4, 6, Vec3(0.05, 0.04, 0.06)), 0.0009, GetParam());
  const Material material{.young_modulus = 1e5, .poisson_ratio = 0.45};
  const auto K = stiffness(mesh, {&material, 1});
  Eigen::Matrix3d H;
  for (double& value : H.reshaped()) value = entry(random);
  Eigen::Matrix3Xd field(3, static_cast<Eigen::Index>(mesh.nodes.size()));
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    field.col(static_cast<Eigen::Index>(i)) = H * mesh.nodes[i];

  const std::vector<int> inner = inner_nodes(mesh);
  Eigen::Matrix3Xd on_boundary = field;
  on_boundary(Eigen::all, inner).setZero();
  const auto boundary = nodes_of(mesh, {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"});
  const Eigen::Matrix3Xd u = on_boundary + static_solve(K, boundary, -times(K, on_boundary));
  // 1e-12: round-off of a few hundred unknowns times the condition of the inner problem (about 1e2).
  EXPECT_LT((u - field).cwiseAbs().maxCoeff(), 1e-12 * field.cwiseAbs().maxCoeff());
  const Eigen::VectorXd stress = von_mises(mesh, {&material, 1}, u);
  EXPECT_LT(stress.maxCoeff() - stress.minCoeff(), 1e-10 * stress.maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(Fields, PatchTest, testing::Range(1U, 6U));

/// Mean deflection of the loaded end of a clamped bar of square section, load spread over the end as constant
/// shear traction, over the deflection that Timoshenko's beam has: P L^3/(3 E I) + P L/(kappa G A), with
/// kappa = 10 (1 + nu)/(12 + 11 nu) [Cowper 1966].
double tip_ratio(int cells) {
  const double L = 0.06, h = 0.01, P = 0.01;
  const Material material{.young_modulus = 1e5, .poisson_ratio = 0.3};
  const TetMesh mesh = box_mesh(6 * cells, cells, cells, Vec3(L, h, h));
  const std::vector<int>& end = mesh.node_groups.at("x_max");
  Eigen::Matrix3Xd f = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(mesh.nodes.size()));
  for (const Tetrahedron& t : mesh.tetrahedra) {  // a third of each end triangle's load to each of its nodes
    std::vector<int> on_end;
    for (const int node : t)
      if (std::ranges::binary_search(end, node)) on_end.push_back(node);
    if (on_end.size() == 3)
      for (const int node : on_end) f(2, node) += P / (6.0 * cells * cells);
  }
  EXPECT_NEAR(f.row(2).sum(), P, 1e-12 * P);
  const auto K = stiffness(mesh, {&material, 1});
  const Eigen::Matrix3Xd u = static_solve(K, mesh.node_groups.at("x_min"), f);
  const double deflection = f.row(2).dot(u.row(2)) / P;

  const double E = material.young_modulus, nu = material.poisson_ratio, I = std::pow(h, 4) / 12;
  const double G = E / (2 * (1 + nu)), kappa = 10 * (1 + nu) / (12 + 11 * nu);
  return deflection / (P * std::pow(L, 3) / (3 * E * I) + P * L / (kappa * G * h * h));
}

TEST(StaticSolve, CantileverTendsToBeamTheoryFromBelow) {
  const double coarse = tip_ratio(4), middle = tip_ratio(8), fine = tip_ratio(16);
  EXPECT_LT(coarse, middle);
  EXPECT_LT(middle, fine);
  EXPECT_LT(fine, 1.0);  // work of the load = twice the energy, which Galerkin's method never overstates
  // Energy converges with the square of the element's size for linear elements where the solution is smooth;
  // at the clamp's edges, where it is not, it takes longer. Extrapolated (Aitken) beam theory is met within 1
  // %: the clamp also holds back the section's contraction, which beam theory leaves free.
  const double ratio = (middle - coarse) / (fine - middle);
  EXPECT_NEAR(std::log2(ratio), 1.75, 0.35);
  EXPECT_NEAR(fine + (fine - middle) / (ratio - 1), 1.0, 0.01);
}

}  // namespace
}  // namespace palpate::sim
