#pragma once

#include <Eigen/Core>

#include "sim/model/model.hpp"

namespace palpate::sim::test {

/// Forces on the touchable nodes as forces on the whole mesh, 3 x n.
inline Eigen::Matrix3Xd on_mesh(const Body& body, const Eigen::VectorXd& loads) {
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(body.mesh->nodes.size()));
  for (std::size_t i = 0; i < body.compliance->touch.size(); ++i)
    forces.col(body.compliance->touch[i]) = loads.segment<3>(3 * static_cast<Eigen::Index>(i));
  return forces;
}

}  // namespace palpate::sim::test
