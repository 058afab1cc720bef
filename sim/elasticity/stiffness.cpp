#include "sim/elasticity/stiffness.hpp"

#include <algorithm>
#include <vector>

#include "sim/elasticity/tetrahedron.hpp"

namespace palpate::sim {
namespace {

using ElementMatrix = Eigen::Matrix<double, 12, 12>;

/// K_e = V B^T D B, block by block: V (lambda g_a g_b^T + mu g_b g_a^T + mu (g_a . g_b) I). The upper
/// triangle is the mirror of the lower one, so that K is symmetric to the last bit.
ElementMatrix element_stiffness(const TetrahedronShape& shape, const Material& material) {
  const auto [lambda, mu] = lame(material);
  ElementMatrix K_e;
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b <= a; ++b) {
      const Vec3 g_a = shape.gradient.col(a), g_b = shape.gradient.col(b);
      K_e.block<3, 3>(3 * a, 3 * b) =
          shape.volume * (lambda * g_a * g_b.transpose() + mu * g_b * g_a.transpose() +
                          mu * g_a.dot(g_b) * Eigen::Matrix3d::Identity());
    }
  return K_e.selfadjointView<Eigen::Lower>();
}

/// For each node, the nodes that share a tetrahedron with it, itself included, ascending.
std::vector<std::vector<int>> neighbours(const TetMesh& mesh) {
  std::vector<std::vector<int>> of(mesh.nodes.size());
  for (const Tetrahedron& corners : mesh.tetrahedra)
    for (const int a : corners) of[a].insert(of[a].end(), corners.begin(), corners.end());
  for (std::vector<int>& list : of) {
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
    list.shrink_to_fit();
  }
  return of;
}

/// A matrix of 3 x 3 blocks of zeros, one for each pair of neighbours.
Eigen::SparseMatrix<double> zero_blocks(const std::vector<std::vector<int>>& neighbours) {
  const auto unknowns = static_cast<Eigen::Index>(3 * neighbours.size());
  Eigen::SparseMatrix<double> K(unknowns, unknowns);
  Eigen::VectorXi entries(unknowns);
  for (Eigen::Index column = 0; column < unknowns; ++column)
    entries[column] = static_cast<int>(3 * neighbours[column / 3].size());
  K.reserve(entries);
  for (Eigen::Index column = 0; column < unknowns; ++column)
    for (const int node : neighbours[column / 3])
      for (int axis = 0; axis < 3; ++axis) K.insert(3 * node + axis, column) = 0.0;
  K.makeCompressed();
  return K;
}

}  // namespace

Eigen::SparseMatrix<double> stiffness(const TetMesh& mesh, std::span<const Material> materials) {
  validate(mesh, materials);
  const std::vector<std::vector<int>> around = neighbours(mesh);
  Eigen::SparseMatrix<double> K = zero_blocks(around);
  for (std::size_t e = 0; e < mesh.tetrahedra.size(); ++e) {
    const ElementMatrix K_e = element_stiffness(shape_of(mesh, e), material_of(mesh, materials, e));
    for (int b = 0; b < 4; ++b) {
      const int node_b = mesh.tetrahedra[e][b];
      const std::vector<int>& rows = around[node_b];
      for (int a = 0; a < 4; ++a) {
        const auto place = std::ranges::lower_bound(rows, mesh.tetrahedra[e][a]);
        const auto block = 3 * (place - rows.begin());
        for (int column = 0; column < 3; ++column) {
          double* values = K.valuePtr() + K.outerIndexPtr()[3 * node_b + column] + block;
          Eigen::Map<Vec3>(values) += K_e.block<3, 1>(3 * a, 3 * b + column);
        }
      }
    }
  }
  return K;
}

}  // namespace palpate::sim
