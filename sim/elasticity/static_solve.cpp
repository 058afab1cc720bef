#include "sim/elasticity/static_solve.hpp"

#include <cassert>

#include "sim/elasticity/supported_stiffness.hpp"

namespace palpate::sim {

Eigen::Matrix3Xd static_solve(const Eigen::SparseMatrix<double>& K, std::span<const int> fixed,
                              const Eigen::Matrix3Xd& forces) {
  assert(forces.size() == K.cols());
  const SupportedStiffness supported(K, fixed);
  const std::vector<int>& order = supported.order();
  const Eigen::Matrix3Xd ordered = forces(Eigen::all, order);
  const Eigen::MatrixXd u = supported.solve(ordered.reshaped());
  Eigen::Matrix3Xd displacements = Eigen::Matrix3Xd::Zero(3, forces.cols());
  displacements(Eigen::all, order) = u.reshaped(3, ordered.cols());
  return displacements;
}

}  // namespace palpate::sim
