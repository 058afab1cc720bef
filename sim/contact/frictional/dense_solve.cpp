#include "sim/contact/frictional/dense_solve.hpp"

#include <Eigen/Core>
#include <cmath>
#include <utility>

namespace palpate::sim {

bool solve_dense(std::span<double> matrix, std::span<double> right) {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto n = std::ssize(right);
  Eigen::Map<Matrix> A(matrix.data(), n, n);
  Eigen::Map<Eigen::VectorXd> b(right.data(), n);
  for (Eigen::Index k = 0; k < n; ++k) {
    Eigen::Index pivot = 0;
    A.col(k).tail(n - k).cwiseAbs().maxCoeff(&pivot);
    pivot += k;
    if (!(std::abs(A(pivot, k)) > 0.0)) return false;
    if (pivot != k) {
      for (Eigen::Index j = k; j < n; ++j) std::swap(A(k, j), A(pivot, j));
      std::swap(b[k], b[pivot]);
    }
    for (Eigen::Index i = k + 1; i < n; ++i) {
      const double factor = A(i, k) / A(k, k);
      if (factor == 0.0) continue;
      A.row(i).tail(n - k - 1) -= factor * A.row(k).tail(n - k - 1);
      b[i] -= factor * b[k];
    }
  }
  for (Eigen::Index k = n; k-- > 0;)
    b[k] = (b[k] - A.row(k).tail(n - k - 1).dot(b.tail(n - k - 1))) / A(k, k);
  return b.allFinite();
}

}  // namespace palpate::sim
