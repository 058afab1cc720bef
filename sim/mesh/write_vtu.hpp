#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <string>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// Fields written beside a mesh: vectors on nodes (3 x n), scalars on tetrahedra.
struct VtuFields {
  std::map<std::string, Eigen::Matrix3Xd> point_vectors;
  std::map<std::string, Eigen::VectorXd> cell_scalars;
};

/// An ASCII VTK unstructured grid with all digits. Node groups are point data `group.NAME` (0 or 1), regions cell data
/// `region` (index into region_names, -1 for none).
std::string vtu_text(const TetMesh& mesh, const VtuFields& fields);

/// Writes it aside and then renames it. Throws std::system_error when the disk refuses.
void write_vtu(const std::filesystem::path& file, const TetMesh& mesh, const VtuFields& fields);

}  // namespace palpate::sim
