#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <span>
#include <vector>

#include "sim/elasticity/stiffness.hpp"
#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// A body whose tetrahedra were cut in eight, while its touched surface stayed as it was: nodes that came to lie on a
/// touched triangle follow its corners, so that what can be touched moves as before and the force is more accurate. Not
/// cut at all, it is the mesh's own stiffness.
struct FinerBody {
  std::vector<Vec3> nodes{};        // that are free to move: those of the mesh first, then added ones [m]
  Eigen::SparseMatrix<double> K{};  // of these nodes, unknowns as stiffness() has them
  std::vector<std::array<int, 2>>
      between{};  // of each added node: the ends of the edge of the surface that it
                  // halves, or -1, -1 inside
};

/// @param touched  ascending node indices: triangles of the surface between them stay
/// @param cuts     how often each tetrahedron is cut in eight
/// Throws std::invalid_argument as stiffness() does.
FinerBody finer_inside(const TetMesh& mesh, std::span<const Material> materials, std::span<const int> touched,
                       int cuts);

/// A group of the mesh's nodes with the added nodes that lie between them on the surface, ascending.
std::vector<int> with_added(const FinerBody& body, std::vector<int> group);

}  // namespace palpate::sim
