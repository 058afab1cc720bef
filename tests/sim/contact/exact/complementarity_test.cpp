#include "sim/contact/exact/complementarity.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <optional>
#include <random>

#include "tests/sim/contact/exact/lemke.hpp"

namespace palpate::sim {
namespace {

using test::ContactProblem;
using test::lemke;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Rows whose compliance spans six decades, as those of a soft and a hard organ do.
ContactProblem random_problem(int bilateral, int contacts, std::mt19937_64& random, int rank_lost = 0) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> decade(-3, 3);
  const int n = bilateral + contacts;
  MatrixXd root(n, n - rank_lost);
  for (Index i = 0; i < root.size(); ++i) root.data()[i] = normal(random);
  VectorXd scale(n);
  for (Index i = 0; i < n; ++i) scale[i] = std::pow(10.0, decade(random) / 2);
  ContactProblem problem;
  problem.system = {.compliance = scale.asDiagonal() * MatrixXd(root * root.transpose()) * scale.asDiagonal(),
                    .bilateral = bilateral,
                    .first_of_probe = {0, bilateral}};
  for (int i = 0; i < bilateral; ++i) {
    problem.holds.push_back(1);
    problem.values.push_back(scale[i] * normal(random));
  }
  const VectorXd reached = root * VectorXd::NullaryExpr(n - rank_lost, [&] { return normal(random); });
  for (int i = bilateral; i < n; ++i)  // within what forces can reach where rows depend on each other
    problem.gaps.push_back(scale[i] * (rank_lost > 0 ? reached[i] : normal(random)));
  return problem;
}

/// Forces with one set of closed contacts, the others open; nothing where a sign is wrong.
std::optional<VectorXd> with_closed(const ContactProblem& problem, unsigned closed) {
  const MatrixXd& K = problem.system.compliance;
  const Index p = problem.system.bilateral, n = K.rows();
  std::vector<Index> rows;
  VectorXd right(n);
  for (Index i = 0; i < n; ++i) {
    if (i < p ? !problem.holds[i] : !(closed >> (i - p) & 1U)) continue;
    right[std::ssize(rows)] = i < p ? problem.values[i] : -problem.gaps[i - p];
    rows.push_back(i);
  }
  const Index size = std::ssize(rows);
  VectorXd x = VectorXd::Zero(n);
  const VectorXd forces = MatrixXd(K(rows, rows)).ldlt().solve(right.head(size));
  for (Index i = 0; i < size; ++i) x[rows[i]] = forces[i];
  const VectorXd moved = K * x;
  for (Index i = p; i < n; ++i)
    if (x[i] < 0 || (x[i] == 0 && problem.gaps[i - p] + moved[i] < 0)) return std::nullopt;
  return x;
}

/// In units in which every row's compliance is 1, for rows differ by six decades.
double difference(const ContactProblem& problem, const VectorXd& a, const VectorXd& b) {
  const VectorXd unit = problem.system.compliance.diagonal().cwiseSqrt();
  return (a - b).cwiseProduct(unit).norm() / b.cwiseProduct(unit).norm();
}

// Compliances span six decades, so the dense solution itself has some 1e-9 of error, and Lemke's tableau, which is
// never factorised anew, more.
TEST(Complementarity, IsTheOneSetOfContactsThatFits) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 300; ++trial) {
    const ContactProblem problem = random_problem(trial % 4, 1 + trial % 8, random);
    ComplementaritySolve solve(problem.system);
    const auto report = solve.solve(problem.holds, problem.values, problem.gaps);
    EXPECT_EQ(report.end, ComplementarityReport::End::Converged);
    EXPECT_LE(report.residual, 1e-10);
    int fitting = 0;
    for (unsigned closed = 0; closed < 1U << problem.gaps.size(); ++closed) {
      const auto x = with_closed(problem, closed);
      if (!x) continue;
      ++fitting;
      EXPECT_LE((solve.forces() - *x).norm(), 1e-7 * x->norm()) << trial;
    }
    EXPECT_EQ(fitting, 1) << trial;
  }
}

TEST(Complementarity, AgreesWithLemke) {
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 60; ++trial) {
    const ContactProblem problem = random_problem(3, 10 + trial, random);
    ComplementaritySolve solve(problem.system);
    EXPECT_LE(solve.solve(problem.holds, problem.values, problem.gaps).residual, 1e-10);
    EXPECT_LE(difference(problem, solve.forces(), lemke(problem)), 1e-6) << trial;
  }
}

TEST(Complementarity, FollowsChangingGapsAsFromAFreshStart) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> step(0.0, 0.05);
  ContactProblem problem = random_problem(3, 40, random);
  const VectorXd unit = problem.system.compliance.diagonal().cwiseSqrt();
  ComplementaritySolve warm(problem.system);
  int iterations = 0;
  for (int cycle = 0; cycle < 2000; ++cycle) {
    for (std::size_t i = 0; i < problem.gaps.size(); ++i)
      problem.gaps[i] += unit[3 + static_cast<Index>(i)] * step(random);
    problem.holds[1] = cycle % 100 < 50 ? 1 : 0;
    const auto report = warm.solve(problem.holds, problem.values, problem.gaps);
    ASSERT_EQ(report.end, ComplementarityReport::End::Converged);
    ASSERT_LE(report.residual, 1e-10);
    iterations += report.iterations;
    if (cycle % 20 != 0) continue;
    ComplementaritySolve fresh(problem.system);
    fresh.solve(problem.holds, problem.values, problem.gaps);
    ASSERT_LE(difference(problem, warm.forces(), fresh.forces()), 1e-8) << cycle;
  }
  EXPECT_LT(iterations, 2000 * 5);
}

// The same contact twice, and more contacts than the bodies can tell apart: their common push is one.
TEST(Complementarity, SharesWhatRedundantContactsPush) {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 100; ++trial) {
    const ContactProblem problem = random_problem(2, 12, random, 5);
    ComplementaritySolve solve(problem.system);
    const auto report = solve.solve(problem.holds, problem.values, problem.gaps);
    EXPECT_EQ(report.end, ComplementarityReport::End::Converged);
    EXPECT_LE(report.residual, 1e-10);
    EXPECT_TRUE(solve.forces().allFinite());
  }
  ContactProblem twice = random_problem(1, 4, random);
  MatrixXd& K = twice.system.compliance;
  const std::vector<Index> rows{0, 1, 2, 3, 4, 4};
  twice.gaps = {1.0, 1.0, 1.0, -K(4, 4)};
  const ContactProblem once = twice;
  ComplementaritySolve one(once.system);
  one.solve(once.holds, once.values, once.gaps);
  K = MatrixXd(once.system.compliance(rows, rows));
  twice.gaps.push_back(twice.gaps.back());
  ComplementaritySolve two(twice.system);
  const auto report = two.solve(twice.holds, twice.values, twice.gaps);
  EXPECT_LE(report.residual, 1e-10);
  EXPECT_NEAR((two.forces()[4] + two.forces()[5]) / one.forces()[4], 1.0, 1e-9);
}

TEST(UpdatedFactor, IsTheFactorOfTheRowsThatAreThere) {
  std::mt19937_64 random(5);
  const MatrixXd K = random_problem(0, 30, random).system.compliance;
  UpdatedFactor factor(K, 0.0);
  std::vector<int> rows;
  for (int change = 0; change < 500; ++change) {
    const int row = std::uniform_int_distribution<int>(0, 29)(random);
    const auto found = std::ranges::find(rows, row);
    if (found == rows.end()) {
      factor.append(row);
      rows.push_back(row);
    } else {
      factor.remove(static_cast<std::size_t>(found - rows.begin()));
      rows.erase(found);
    }
    ASSERT_TRUE(std::ranges::equal(factor.rows(), rows));
    if (rows.empty()) continue;
    VectorXd x = VectorXd::Random(std::ssize(rows));
    const MatrixXd block = K(rows, rows);
    const VectorXd right = block * x;
    VectorXd found_x = right;
    factor.solve(std::span(found_x.data(), rows.size()));
    ASSERT_LE((block * found_x - right).cwiseQuotient(block.diagonal().cwiseSqrt()).norm(),
              1e-9 * right.cwiseQuotient(block.diagonal().cwiseSqrt()).norm());
  }
}

}  // namespace
}  // namespace palpate::sim
