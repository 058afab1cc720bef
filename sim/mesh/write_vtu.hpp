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

/// Writes an ASCII VTK unstructured grid with all digits, aside and then renamed. Node groups are written as
/// point data `group.NAME` (0 or 1), regions as cell data `region` (index into region_names, -1 for none).
/// Throws std::system_error when the disk refuses.
void write_vtu(const std::filesystem::path& file, const TetMesh& mesh, const VtuFields& fields);

}  // namespace palpate::sim
