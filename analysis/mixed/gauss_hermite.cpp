#include "analysis/mixed/gauss_hermite.hpp"

#include <Eigen/Eigenvalues>
#include <cassert>
#include <cmath>
#include <numbers>

namespace palpate::analysis {

std::vector<QuadratureNode> gauss_hermite(int n) {
  assert(n >= 1);
  if (n == 1) return {{.t = 0.0, .weight = std::sqrt(std::numbers::pi)}};
  const Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(n);
  const Eigen::VectorXd beside = (Eigen::VectorXd::LinSpaced(n - 1, 1, n - 1) / 2).cwiseSqrt();
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal, beside);
  std::vector<QuadratureNode> nodes(n);
  for (int k = 0; k < n; ++k) {
    // Averaged with its mirror image, so that the rule is symmetric to the last bit.
    const double t = (solver.eigenvalues()[k] - solver.eigenvalues()[n - 1 - k]) / 2;
    const double first = solver.eigenvectors()(0, k), mirror = solver.eigenvectors()(0, n - 1 - k);
    nodes[k] = {.t = t, .weight = std::sqrt(std::numbers::pi) * (first * first + mirror * mirror) / 2};
  }
  return nodes;
}

}  // namespace palpate::analysis
