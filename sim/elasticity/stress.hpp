#pragma once

#include <Eigen/Core>
#include <span>

#include "sim/elasticity/stiffness.hpp"

namespace palpate::sim {

/// Von Mises stress of each tetrahedron [Pa] for nodal displacements u (3 x n) [m].
Eigen::VectorXd von_mises(const TetMesh& mesh, std::span<const Material> materials,
                          const Eigen::Matrix3Xd& u);

}  // namespace palpate::sim
