#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace palpate::sim {

using Vec3 = Eigen::Vector3d;
using Triangle = std::array<int, 3>;
using Tetrahedron = std::array<int, 4>;

/// A body at rest: linear tetrahedra with the named groups of its file.
struct TetMesh {
  std::vector<Vec3> nodes{};                // rest positions [m]
  std::vector<Tetrahedron> tetrahedra{};    // node indices, every volume positive
  std::vector<int> region{};                // of each tetrahedron: index into region_names, -1 for none
  std::vector<std::string> region_names{};  // named volume groups
  std::map<std::string, std::vector<int>>
      node_groups{};                      // named groups of any dimension -> ascending node indices
  std::vector<std::int64_t> node_tags{};  // the number that the file gives each node
};

}  // namespace palpate::sim
