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

/// Reads Gmsh MSH 2.2 or 4.1 (ASCII or binary) or VTU (ASCII, base64 or raw, plain or zlib), told apart by
/// content. First-order tetrahedra are the body; points, lines and triangles only name groups; other elements
/// are refused. What Gmsh alone reads (convert_mesh.hpp) is converted by it first.
///
/// MSH: named physical groups of every dimension become node groups (an empty one stays, empty), those of
/// volumes regions as well. A tetrahedron in several named volumes counts to the one with the fewest
/// tetrahedra, as a nodule within a body; a name whose tetrahedra all count to others has no tetrahedron in
/// `region`. VTU has no names: point data arrays `group.NAME` of whole numbers (UInt8) are masks of node
/// groups, the cell data array `region` gives ids, written as the regions' names ("0", "7"; negative for
/// none); node tags are indices.
///
/// Duplicate nodes are welded when they lie within 1e-9 of the diagonal of the tetrahedra's bounding box.
/// @param metres_per_unit  what one unit of the file's coordinates is [m]
/// Throws std::invalid_argument that names the file, the line (or byte offset) and what is accepted.
MeshFile read_mesh(const std::filesystem::path& file, double metres_per_unit);

}  // namespace palpate::sim
