#pragma once

#include <span>

namespace palpate::sim {

/// Solves A x = b in place by Gaussian elimination with row pivoting, without taking memory: Eigen's solvers take it
/// for their permutations, and a cycle may not. A is square, row by row, and is lost.
/// @return false where a pivot is 0 or no number
bool solve_dense(std::span<double> matrix, std::span<double> right);

}  // namespace palpate::sim
