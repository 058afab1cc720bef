#pragma once

#include <filesystem>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim::test {

/// A block as wide as twice `half`, from z = 0 down to -half, made by Gmsh in a folder: edges h within `fine` of the
/// middle of its top, from there on growing by `growth` of the distance. Lengths in metres.
struct GradedBlock {
  double half = 0.16;
  double h = 1e-3;
  double fine = 3e-3;
  double growth = 0.5;
};
TetMesh graded_block(const std::filesystem::path& folder, const GradedBlock& block);

}  // namespace palpate::sim::test
