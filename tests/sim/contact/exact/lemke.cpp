#include "tests/sim/contact/exact/lemke.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>

namespace palpate::sim::test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd lemke(const ContactProblem& problem) {
  const MatrixXd& K = problem.system.compliance;
  const Index p = problem.system.bilateral, m = K.rows() - p;
  const MatrixXd inverse = K.topLeftCorner(p, p).inverse(), coupling = K.bottomLeftCorner(m, p);
  const VectorXd values = VectorXd::Map(problem.values.data(), p),
                 gaps = VectorXd::Map(problem.gaps.data(), m);
  const MatrixXd M = K.bottomRightCorner(m, m) - coupling * inverse * coupling.transpose();
  const VectorXd q = gaps + coupling * inverse * values;
  const VectorXd unit = M.diagonal().cwiseSqrt();  // scaled: M_ii = 1
  MatrixXd tableau(m, 2 * m + 2);                  // w - M z - d z0 = q
  tableau << MatrixXd::Identity(m, m),
      -MatrixXd(unit.cwiseInverse().asDiagonal() * M * unit.cwiseInverse().asDiagonal()), -VectorXd::Ones(m),
      q.cwiseQuotient(unit);
  std::vector<Index> basis(m);
  for (Index i = 0; i < m; ++i) basis[i] = i;
  VectorXd z = VectorXd::Zero(m);
  Index row = 0;
  if (tableau.col(2 * m + 1).minCoeff(&row) < 0) {
    Index entering = 2 * m;
    for (int pivot = 0; pivot < 10000; ++pivot) {
      const Index leaving = basis[row];
      tableau.row(row) /= tableau(row, entering);
      for (Index i = 0; i < m; ++i)
        if (i != row) tableau.row(i) -= tableau(i, entering) * tableau.row(row);
      basis[row] = entering;
      if (leaving == 2 * m) break;
      entering = leaving < m ? leaving + m : leaving - m;
      double least = std::numeric_limits<double>::infinity();
      for (Index i = 0; i < m; ++i)
        if (tableau(i, entering) > 1e-12) {
          const double ratio = tableau(i, 2 * m + 1) / tableau(i, entering);
          if (ratio < least || (ratio == least && basis[i] == 2 * m)) least = ratio, row = i;
        }
    }
    for (Index i = 0; i < m; ++i)
      if (basis[i] >= m && basis[i] < 2 * m) z[basis[i] - m] = tableau(i, 2 * m + 1);
  }
  VectorXd x(p + m);
  x.tail(m) = z.cwiseQuotient(unit);
  x.head(p) = inverse * (values - coupling.transpose() * x.tail(m));
  return x;
}

}  // namespace palpate::sim::test
