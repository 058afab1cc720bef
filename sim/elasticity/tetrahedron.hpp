#pragma once

#include <Eigen/Core>

#include "sim/elasticity/stiffness.hpp"
#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// A linear tetrahedron at rest.
struct TetrahedronShape {
  double volume = 0.0;                   // V [m^3]
  Eigen::Matrix<double, 3, 4> gradient;  // of the four shape functions, grad N_a in column a [1/m]
};

/// Volume and shape function gradients of one tetrahedron of the mesh, from differences of positions only.
/// Throws std::invalid_argument that names the tetrahedron when its volume is not positive.
TetrahedronShape shape_of(const TetMesh& mesh, std::size_t tetrahedron);

/// Lame's constants of a material [Pa].
struct Lame {
  double lambda = 0.0;  // E nu / ((1 + nu) (1 - 2 nu))
  double mu = 0.0;      // E / (2 (1 + nu))
};

Lame lame(const Material& material);

/// The material of a tetrahedron: materials[0] without region, materials[1 + r] in region r.
const Material& material_of(const TetMesh& mesh, std::span<const Material> materials,
                            std::size_t tetrahedron);

/// Throws std::invalid_argument that names the first material outside its bounds (E > 0, -1 < nu < 0.5).
void validate(const TetMesh& mesh, std::span<const Material> materials);

}  // namespace palpate::sim
