#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>
#include <vector>

namespace palpate::sim {

/// Displacement per unit force of a supported body, between the nodes that can be touched and towards the
/// nodes that are drawn: the inverse of the condensed stiffness. Scales as 1/E for a body whose moduli all
/// scale together.
struct Compliance {
  std::vector<int> touch;       // mesh node of each touch index, ascending; t of them, none fixed
  std::vector<int> drawn;       // mesh node of each drawn index, ascending; d of them, none fixed
  Eigen::MatrixXd touch_touch;  // u_T = C_TT f_T, 3t x 3t, symmetric positive definite [m/N]
  Eigen::MatrixXf drawn_touch;  // u_D = C_DT f_T, 3d x 3t [m/N], single precision: for pictures only
};

/// Static condensation, exact for loads on touched nodes: C_TT is the block of K^-1 with the fixed nodes
/// struck out. Touchable unknowns are ordered last, so that the trailing block of the sparse Cholesky factor
/// is the factor of the condensed stiffness itself and C_TT needs no column solves.
/// @param K  3n x 3n [N/m];  fixed, touch, drawn: ascending node indices, touch and drawn disjoint from fixed
/// Throws std::invalid_argument when the supports leave a rigid motion (names the missing rank).
/// Source: [BroNielsen1998]; [Hirota1998].
Compliance condense(const Eigen::SparseMatrix<double>& K, std::span<const int> fixed,
                    std::span<const int> touch, std::span<const int> drawn);

}  // namespace palpate::sim
