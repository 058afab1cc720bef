#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace palpate::sim {

/// Cholesky factor of a block K_RR + delta diag(K_RR) of a constant matrix, where the rows R come and go one by one:
/// L L^T. Entering or leaving costs |R|^2. Source: [GolubVanLoan2013] section 6.5.4.
class UpdatedFactor {
 public:
  /// All storage is taken here. @param matrix  symmetric, positive semidefinite; outlives the factor
  UpdatedFactor(const Eigen::MatrixXd& matrix, double delta);

  void clear() { rows_.clear(); }
  void append(int row);
  /// @param at  place of the row that leaves within rows()
  void remove(std::size_t at);
  std::span<const int> rows() const { return rows_; }
  /// Leaves the first `count` rows.
  void truncate(std::size_t count) { rows_.resize(count); }

  /// L^-1 x for a right-hand side in the order of rows(), in place.
  void forward(std::span<double> x) const;
  /// L^-T x, in place.
  void backward(std::span<double> x) const;

  /// Solves for a right-hand side in the order of rows(), in place.
  void solve(std::span<double> x) const { solve_leading(x, rows_.size()); }
  /// The same for the first `count` rows alone.
  void solve_leading(std::span<double> x, std::size_t count) const;

 private:
  double* row(std::size_t i) { return factor_.data() + i * stride_; }
  const double* row(std::size_t i) const { return factor_.data() + i * stride_; }

  struct Rotation {
    double cosine = 1.0, sine = 0.0;
  };

  const Eigen::MatrixXd* matrix_;
  double delta_;
  std::size_t stride_;
  std::vector<int> rows_;
  std::vector<Rotation> rotations_;
  std::vector<double> factor_;  // lower triangle, one row after the other
};

}  // namespace palpate::sim
