#pragma once

#include <string>
#include <string_view>

#include "sim/mesh/read_mesh.hpp"

namespace palpate::sim {

/// read_mesh for bytes that are already in memory; `name` is the file's name in messages.
MeshFile parse_mesh(std::string_view bytes, const std::string& name, double metres_per_unit);

/// One format each: the mesh as it stands in the file, in its own unit, nothing mended. Every index is in
/// range and every coordinate finite.
TetMesh parse_msh(std::string_view bytes, const std::string& name);
TetMesh parse_vtu(std::string_view bytes, const std::string& name);

/// Scales to metres, welds duplicate nodes, leaves unreferenced ones out, exchanges two nodes of tetrahedra
/// with negative volume. Throws std::invalid_argument when a tetrahedron has the same node twice.
MeshFile mend(TetMesh mesh, const std::string& name, double metres_per_unit);

}  // namespace palpate::sim
