#pragma once

#include <vector>

namespace palpate::analysis {

/// One point of a rule for integrals of f(t) exp(-t^2) over the real line.
struct QuadratureNode {
  double t = 0.0;
  double weight = 0.0;
};

/// Gauss-Hermite quadrature, exact for polynomials up to degree 2n - 1: nodes in rising order, symmetric
/// about 0. From the eigenvalues of the Jacobi matrix [GolubWelsch1969]. n >= 1.
std::vector<QuadratureNode> gauss_hermite(int n);

}  // namespace palpate::analysis
