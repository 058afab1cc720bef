#pragma once

#include <vector>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

struct RodPoint {
  Vec3 position = Vec3::Zero();  // [m]
  Vec3 normal = Vec3::Zero();    // outwards, unit length
};

/// A rod with round ends along z: its round ends are centred on 0 and on (0, 0, length).
/// @return three points a triangle, anticlockwise from outside
std::vector<RodPoint> rod(double radius, double length);

}  // namespace palpate::sim
