#pragma once

#include <array>
#include <vector>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// Corners of a tetrahedron's four faces, each anticlockwise seen from outside a positive volume.
inline constexpr std::array<Triangle, 4> kOutwardFaces = {{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};

/// One face of one tetrahedron.
struct Face {
  Triangle corners{};  // node indices, anticlockwise from outside
  Triangle key{};      // the same, ascending: equal for the faces that coincide
  int tetrahedron = 0;
};

/// All 4 x n faces, those that coincide side by side, by ascending key and tetrahedron.
std::vector<Face> sorted_faces(const TetMesh& mesh);

/// Whether two coinciding faces are seen in the same turning sense, so that their tetrahedra lie on one side.
bool same_sense(const Face& a, const Face& b);

}  // namespace palpate::sim
