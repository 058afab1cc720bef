#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>

namespace palpate::sim {

/// Displacements of every node under nodal forces, some nodes fixed: the uncondensed problem K u = f, by
/// sparse Cholesky. For pictures, VTU files and tests, outside the haptic cycle.
/// @param forces  3 x n [N]; entries on fixed nodes are ignored
/// @return u, 3 x n [m], zero on fixed nodes
/// Throws std::invalid_argument when the supports leave a rigid motion, and says which rank is missing.
Eigen::Matrix3Xd static_solve(const Eigen::SparseMatrix<double>& K, std::span<const int> fixed,
                              const Eigen::Matrix3Xd& forces);

}  // namespace palpate::sim
