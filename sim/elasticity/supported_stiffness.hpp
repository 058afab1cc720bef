#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <span>
#include <vector>

namespace palpate::sim {

/// A body's stiffness with the fixed nodes struck out and the rest put into an order that keeps the factor
/// sparse: A = P K P^T = L L^T, by CHOLMOD (supernodal, AMD or METIS ordering). Nodes named `last` come last,
/// in their own order, so that the trailing block of L is the Cholesky factor of the stiffness condensed to
/// them. Rows of every matrix below are in that order, x y z of each node.
/// Source: [Chen2008].
class SupportedStiffness {
 public:
  /// @param K  3n x 3n, symmetric;  fixed, last: ascending node indices, disjoint
  /// Throws std::invalid_argument when a rigid motion is left, std::runtime_error when memory is short.
  SupportedStiffness(const Eigen::SparseMatrix<double>& K, std::span<const int> fixed,
                     std::span<const int> last = {});
  ~SupportedStiffness();
  SupportedStiffness(const SupportedStiffness&) = delete;
  SupportedStiffness& operator=(const SupportedStiffness&) = delete;

  const std::vector<int>& order() const;     // node of each place
  const std::vector<int>& place_of() const;  // place of each node, -1 for fixed ones

  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;             // A^-1 b
  Eigen::MatrixXd solve_transposed(const Eigen::MatrixXd& b) const;  // L^-T b
  Eigen::MatrixXd trailing_factor() const;  // L of the `last` nodes, dense, lower triangle, zeros above

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

}  // namespace palpate::sim
