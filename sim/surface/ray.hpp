#pragma once

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// Distance from p along the unit vector `along` to triangle abc, infinite when it is missed or lies behind.
/// Source: [MollerTrumbore1997].
double distance_to_triangle(const Vec3& p, const Vec3& along, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace palpate::sim
