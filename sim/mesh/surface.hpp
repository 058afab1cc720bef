#pragma once

#include <vector>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// The boundary of a mesh: faces that belong to one tetrahedron only, seen anticlockwise from outside.
struct Surface {
  std::vector<Triangle> triangles{};  // node indices
  std::vector<int> nodes{};           // ascending, each node of a triangle once
  std::vector<int> behind{};          // of each triangle, the tetrahedron that it belongs to
};

Surface extract_surface(const TetMesh& mesh);

}  // namespace palpate::sim
