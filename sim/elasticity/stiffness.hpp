#pragma once

#include <Eigen/SparseCore>
#include <span>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// Isotropic linear elasticity.
struct Material {
  double young_modulus = 0.0;  // E [Pa], > 0
  double poisson_ratio = 0.0;  // nu [-], -1 < nu < 0.5

  bool operator==(const Material&) const = default;
};

/// Stiffness K of a body of linear (P1) tetrahedra, small strain: K = sum over elements of V B^T D B, 3n x 3n
/// [N/m], unknowns ordered x y z of node 0, x y z of node 1, ...
/// @param materials  materials[0] of tetrahedra without region, materials[1 + r] of region r
/// Throws std::invalid_argument for a material outside its bounds.
/// Source: [Zienkiewicz2013] vol. 1, linear tetrahedron; [BroNielsen1998].
Eigen::SparseMatrix<double> stiffness(const TetMesh& mesh, std::span<const Material> materials);

}  // namespace palpate::sim
