#include "sim/contact/frictional/coulomb.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <numeric>
#include <random>

#include "sim/contact/exact/complementarity.hpp"
#include "sim/contact/frictional/dense_solve.hpp"

namespace palpate::sim {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct FrictionalProblem {
  FrictionSystem system{};
  std::vector<char> holds{};
  std::vector<double> values{};
  std::vector<Vec3> gaps{};
  std::vector<int> near{};
};

/// Contacts on one elastic half-space: K falls with their distance, as a body's does, and each row is its own most.
FrictionalProblem frictional_problem(int probes, int contacts, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const Index n = probes + 3 * contacts;
  MatrixXd root(n, n);
  for (Index i = 0; i < root.size(); ++i) root.data()[i] = normal(random);
  FrictionalProblem problem;
  problem.system.compliance = root * root.transpose() / static_cast<double>(n) + MatrixXd::Identity(n, n);
  problem.system.bilateral = probes;
  problem.system.frames.resize(static_cast<std::size_t>(contacts), Eigen::Matrix3d::Identity());
  for (int i = 0; i < probes; ++i) {
    problem.holds.push_back(1);
    problem.values.push_back(normal(random));
  }
  for (int i = 0; i < contacts; ++i) {
    problem.gaps.emplace_back(normal(random) - 0.7, normal(random), normal(random));
    problem.near.push_back(i);
  }
  return problem;
}

/// What Coulomb's law says, term by term and without a projection; relative to the largest force or gap.
void expect_coulomb(const FrictionalProblem& problem, double friction, const VectorXd& x, double tolerance) {
  const Index p = problem.system.bilateral;
  VectorXd w = problem.system.compliance * x;
  const double unit = std::max(1e-300, x.cwiseAbs().maxCoeff());
  for (Index i = 0; i < p; ++i)
    EXPECT_NEAR(w[i], problem.values[static_cast<std::size_t>(i)], tolerance * unit);
  for (std::size_t i = 0; i < problem.gaps.size(); ++i) {
    const Index row = p + 3 * static_cast<Index>(i);
    const Vec3 apart = w.segment<3>(row) + problem.gaps[i];
    const Vec3 force = x.segment<3>(row);
    const double along = force.tail<2>().norm(), slip = apart.tail<2>().norm();
    EXPECT_GE(force[0], 0.0);
    EXPECT_LE(along, friction * force[0] * (1 + 1e-8));  // the cone
    EXPECT_GE(apart[0], -tolerance * unit);
    EXPECT_LE(force[0] * apart[0], tolerance * unit * unit);
    if (force[0] <= tolerance * unit) continue;
    if (along < friction * force[0] - tolerance * unit)
      EXPECT_LE(slip, tolerance * unit) << "sticks";
    else if (slip > tolerance * unit)
      EXPECT_NEAR(force.tail<2>().dot(apart.tail<2>()), -along * slip, tolerance * unit * unit)
          << "against the slip";
  }
}

TEST(DenseSolve, AgreesWithEigen) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (const Index n : {0, 1, 2, 7, 40}) {
    const Eigen::Matrix<double, -1, -1, Eigen::RowMajor> A =
        MatrixXd::NullaryExpr(n, n, [&] { return normal(random); });
    const VectorXd b = VectorXd::NullaryExpr(n, [&] { return normal(random); });
    std::vector<double> matrix(A.data(), A.data() + A.size()), right(b.data(), b.data() + n);
    ASSERT_TRUE(solve_dense(matrix, right));
    if (n > 0)
      EXPECT_LT((VectorXd::Map(right.data(), n) - A.partialPivLu().solve(b)).norm(), 1e-9 * (1 + b.norm()));
  }
  std::vector<double> singular{1, 2, 2, 4}, right{1, 2};
  EXPECT_FALSE(solve_dense(singular, right));
}

TEST(Coulomb, ObeysItsLaw) {
  std::mt19937_64 random(2);
  for (const double friction : {0.0, 0.1, 0.3, 0.8})
    for (int trial = 0; trial < 100; ++trial) {
      const FrictionalProblem problem = frictional_problem(trial % 4, 1 + trial % 20, random);
      CoulombSolve solve(problem.system);
      const CoulombReport report =
          solve.solve(friction, problem.holds, problem.values, problem.gaps, problem.near);
      EXPECT_TRUE(report.converged) << friction << " " << trial << " " << report.residual;
      expect_coulomb(problem, friction, solve.forces(), 1e-9);
    }
}

// At mu = 1.5 the solution need not be unique: a valid one, and the same one every time.
TEST(Coulomb, SolvesStrongFrictionTheSameWayEveryTime) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const FrictionalProblem problem = frictional_problem(2, 1 + trial % 15, random);
    CoulombSolve solve(problem.system), again(problem.system);
    const CoulombReport report = solve.solve(1.5, problem.holds, problem.values, problem.gaps, problem.near);
    EXPECT_TRUE(report.converged) << trial << " " << report.residual;
    expect_coulomb(problem, 1.5, solve.forces(), 1e-9);
    again.solve(1.5, problem.holds, problem.values, problem.gaps, problem.near);
    EXPECT_EQ(again.forces(), solve.forces());
  }
}

// Without friction it is the complementarity problem of the normal rows, which another solver solves.
TEST(Coulomb, WithoutFrictionIsFrictionlessContact) {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 50; ++trial) {
    const FrictionalProblem problem = frictional_problem(3, 12, random);
    CoulombSolve solve(problem.system);
    solve.solve(0.0, problem.holds, problem.values, problem.gaps, problem.near);
    std::vector<Index> rows{0, 1, 2};
    std::vector<double> gaps;
    for (std::size_t i = 0; i < problem.gaps.size(); ++i) {
      rows.push_back(3 + 3 * static_cast<Index>(i));
      gaps.push_back(problem.gaps[i][0]);
    }
    const ContactSystem normal{
        .compliance = problem.system.compliance(rows, rows), .bilateral = 3, .first_of_probe = {0, 3}};
    ComplementaritySolve frictionless(normal);
    frictionless.solve(problem.holds, problem.values, gaps);
    for (std::size_t i = 0; i < rows.size(); ++i)
      EXPECT_NEAR(solve.forces()[rows[i]], frictionless.forces()[static_cast<Index>(i)],
                  1e-9 * frictionless.forces().norm());
  }
}

}  // namespace
}  // namespace palpate::sim
