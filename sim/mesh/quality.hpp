#pragma once

#include <string>
#include <vector>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// Shape and soundness of a mesh, as `palpate check` and `palpate mesh` print them.
struct MeshQuality {
  int nodes = 0;
  int surface_nodes = 0;
  int tetrahedra = 0;
  int surface_triangles = 0;
  int components = 0;             // pieces that share no node
  double volume = 0.0;            // [m^3]
  double min_dihedral = 0.0;      // smallest angle between two faces of one tetrahedron [degree]
  double max_dihedral = 0.0;      // [degree]
  double min_radius_ratio = 0.0;  // 3 r_in / r_circum, 1 for a regular tetrahedron
  double mean_radius_ratio = 0.0;
  double min_edge = 0.0, max_edge = 0.0;            // [m]
  Vec3 lower = Vec3::Zero(), upper = Vec3::Zero();  // bounding box [m]
  std::vector<std::string> warnings;  // sentences for the user: slivers, unlikely size (unit), ...
};

MeshQuality measure_quality(const TetMesh& mesh);

/// Refuses what cannot be simulated: no tetrahedron, a non-manifold or open surface, a flat tetrahedron.
/// Throws std::invalid_argument that names the elements.
void validate(const TetMesh& mesh);

}  // namespace palpate::sim
