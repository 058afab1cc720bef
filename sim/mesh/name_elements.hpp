#pragma once

#include <cstdint>
#include <string>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// The number that the file gives a node, its index where there was no file.
std::int64_t node_tag(const TetMesh& mesh, int node);

/// "edge 3-8" and "tetrahedron 17 (nodes 3, 8, 9, 14)", for messages: nodes by their tags, tetrahedra counted
/// from 0.
std::string name_edge(const TetMesh& mesh, int a, int b);
std::string name_tetrahedron(const TetMesh& mesh, int tetrahedron);

}  // namespace palpate::sim
