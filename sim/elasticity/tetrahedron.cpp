#include "sim/elasticity/tetrahedron.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cassert>
#include <cmath>
#include <stdexcept>

namespace palpate::sim {

TetrahedronShape shape_of(const TetMesh& mesh, std::size_t tetrahedron) {
  const Tetrahedron& corner = mesh.tetrahedra[tetrahedron];
  const auto at = [&](std::size_t k) -> const Vec3& { return mesh.nodes[corner[k]]; };
  Eigen::Matrix3d edges;
  edges << at(1) - at(0), at(2) - at(0), at(3) - at(0);
  TetrahedronShape shape;
  shape.volume = edges.determinant() / 6;
  if (!(shape.volume > 0))
    throw std::invalid_argument(fmt::format(
        "tetrahedron {} (nodes {}, {}, {}, {} of the mesh, counted from 0) has the volume {} m^3, "
        "must be > 0",
        tetrahedron, corner[0], corner[1], corner[2], corner[3], shape.volume));
  shape.gradient.rightCols<3>() = edges.inverse().transpose();
  shape.gradient.col(0) = -shape.gradient.rightCols<3>().rowwise().sum();
  return shape;
}

Lame lame(const Material& material) {
  const double E = material.young_modulus, nu = material.poisson_ratio;
  return {.lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), .mu = E / (2 * (1 + nu))};
}

const Material& material_of(const TetMesh& mesh, std::span<const Material> materials,
                            std::size_t tetrahedron) {
  assert(mesh.region.size() == mesh.tetrahedra.size());
  const int of_region = 1 + mesh.region[tetrahedron];
  return materials[of_region];
}

void validate(const TetMesh& mesh, std::span<const Material> materials) {
  if (materials.size() != 1 + mesh.region_names.size())
    throw std::invalid_argument(
        fmt::format("{} materials given, must be {}: one for tetrahedra without region, one a region",
                    materials.size(), 1 + mesh.region_names.size()));
  for (std::size_t m = 0; m < materials.size(); ++m) {
    const std::string owner = m == 0 ? "the body" : fmt::format("region '{}'", mesh.region_names[m - 1]);
    const double E = materials[m].young_modulus, nu = materials[m].poisson_ratio;
    if (!(std::isfinite(E) && E > 0))
      throw std::invalid_argument(
          fmt::format("young_modulus of {} = {} Pa, must be finite and > 0", owner, E));
    if (!(nu > -1 && nu < 0.5))
      throw std::invalid_argument(fmt::format("poisson_ratio of {} = {}, must be > -1 and < 0.5", owner, nu));
  }
}

}  // namespace palpate::sim
