#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/view/picture.hpp"

namespace palpate::sim {

/// One corner of a triangle as OpenGL takes it, seen from the camera: x to the right, y up, -z ahead [m].
struct Corner {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  // outwards, unit length
  Eigen::Vector4f colour = Eigen::Vector4f::Zero();  // red, green, blue, opacity
  Eigen::Vector3f edge = Eigen::Vector3f::Ones();    // 0 on the edge across that is drawn, 1 at its corner
};

/// Corners of triangles, three in a row. A body has opaque or translucent ones, never both.
struct Corners {
  std::vector<Corner> opaque;       // in any order
  std::vector<Corner> translucent;  // from far to near
};

/// Everything that a picture shows, seen from its camera.
/// Throws std::invalid_argument for a camera that looks along its `up` or at its own eye.
Corners corners_of(const Picture& picture);

/// Normal at each corner of each triangle: the mean of the triangles around the node, weighted by area, of
/// those that meet this triangle at less than the crease angle. So a cube keeps its edges and a sphere has
/// none.
/// @return 3 x 3m, unit length; zero for a triangle without area
Eigen::Matrix3Xf corner_normals(const Eigen::Matrix3Xf& positions, const std::vector<Triangle>& triangles);

}  // namespace palpate::sim
