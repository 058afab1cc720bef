#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// sRGB, each part from 0 to 1.
struct Colour {
  float red = 0.0F, green = 0.0F, blue = 0.0F;
};

/// A closed surface, shaded smoothly but for its sharp edges.
struct DrawnBody {
  std::string name{};
  Eigen::Matrix3Xf positions{};       // of the nodes, 3 x n [m]
  std::vector<Triangle> triangles{};  // columns of positions, anticlockwise from outside
  std::vector<int> behind{};          // of each triangle, the tetrahedron of the body's mesh
  Colour colour{};
  /// Of each corner of each triangle, instead of `colour`, on a body that is solid; empty: none.
  Eigen::Matrix3Xf corner_colours{};
  float opacity = 1.0F;  // seen face on: 1 solid, less than 1 translucent, 0 not drawn
};

/// A finger or a stylus: a rod with round ends, which touches the skin at `touch`.
struct DrawnProbe {
  Vec3 touch = Vec3::Zero();       // [m]
  Vec3 direction = Vec3::UnitZ();  // of the press, into the body, unit length
  Vec3 shaft = -Vec3::UnitZ();     // from the touching end towards the hand, unit length
  double radius = 0.0;             // [m], > 0
  double length = 0.0;             // of the shaft between the centres of its round ends [m], >= 0
  Colour colour{};
};

/// A camera with perspective.
struct Camera {
  Vec3 eye = Vec3(0, 0, 1);      // [m]
  Vec3 target = Vec3::Zero();    // what the middle of the picture shows [m]
  Vec3 up = Vec3::UnitY();       // upwards in the picture; not along the line of sight
  double field_of_view = 0.524;  // vertical, whole angle [rad]
};

/// All that a picture shows.
struct Picture {
  std::vector<DrawnBody> bodies{};
  std::vector<DrawnProbe> probes{};
  Camera camera{};
  Colour background{0.98F, 0.98F, 0.97F};
  double scale_bar = 0.0;  // length of the bar in the lower left corner, true at the target [m]; 0: no bar
};

}  // namespace palpate::sim
