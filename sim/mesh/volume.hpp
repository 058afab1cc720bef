#pragma once

#include <Eigen/Geometry>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// Signed volume of a tetrahedron [m^3]: positive when the last node lies to the left of the first three,
/// that is det(x1 - x0, x2 - x0, x3 - x0) / 6. Source: [Zienkiewicz2013] ch. 6.
inline double signed_volume(const TetMesh& mesh, const Tetrahedron& tetrahedron) {
  const auto node = [&](std::size_t i) -> const Vec3& { return mesh.nodes[tetrahedron[i]]; };
  return (node(1) - node(0)).cross(node(2) - node(0)).dot(node(3) - node(0)) / 6.0;
}

}  // namespace palpate::sim
