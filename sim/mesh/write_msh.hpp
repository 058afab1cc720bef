#pragma once

#include <filesystem>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// Writes Gmsh MSH 4.1 ASCII with the node and volume groups kept, aside and then renamed.
void write_msh(const std::filesystem::path& file, const TetMesh& mesh);

}  // namespace palpate::sim
