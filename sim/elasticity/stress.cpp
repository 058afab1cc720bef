#include "sim/elasticity/stress.hpp"

#include <Eigen/Dense>
#include <cassert>
#include <cmath>

#include "sim/elasticity/tetrahedron.hpp"

namespace palpate::sim {

Eigen::VectorXd von_mises(const TetMesh& mesh, std::span<const Material> materials,
                          const Eigen::Matrix3Xd& u) {
  assert(u.cols() == static_cast<Eigen::Index>(mesh.nodes.size()));
  validate(mesh, materials);
  Eigen::VectorXd result(static_cast<Eigen::Index>(mesh.tetrahedra.size()));
  for (std::size_t e = 0; e < mesh.tetrahedra.size(); ++e) {
    const TetrahedronShape shape = shape_of(mesh, e);
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();  // du_i / dx_j
    for (int a = 0; a < 4; ++a) gradient += u.col(mesh.tetrahedra[e][a]) * shape.gradient.col(a).transpose();
    const Eigen::Matrix3d strain = (gradient + gradient.transpose()) / 2;
    const Eigen::Matrix3d deviator = strain - strain.trace() / 3 * Eigen::Matrix3d::Identity();
    // sqrt(3/2 s : s) with the deviatoric stress s = 2 mu dev(strain)
    const double mu = lame(material_of(mesh, materials, e)).mu;
    result[static_cast<Eigen::Index>(e)] = std::sqrt(1.5) * 2 * mu * deviator.norm();
  }
  return result;
}

}  // namespace palpate::sim
