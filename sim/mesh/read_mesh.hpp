#pragma once

#include <filesystem>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// What reading had to mend, so that nothing is mended in silence.
struct MeshRepairs {
  int reordered_tetrahedra = 0;  // negative volume, two nodes exchanged
  int welded_nodes = 0;          // duplicates within weld_tolerance
  int unreferenced_nodes = 0;    // in no tetrahedron, left out
  double weld_tolerance = 0.0;   // [m]
};

struct MeshFile {
  TetMesh mesh{};
  MeshRepairs repairs{};
};

/// Reads Gmsh MSH 2.2 or 4.1 (ASCII or binary) or VTU, told apart by content.
/// @param metres_per_unit  what one unit of the file's coordinates is [m]
/// Throws std::invalid_argument that names the file, the line (or byte offset) and what is accepted.
MeshFile read_mesh(const std::filesystem::path& file, double metres_per_unit);

}  // namespace palpate::sim
