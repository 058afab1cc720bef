#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// How a region has moved from rest: its translation t [m], then R - I column by column, R its rotation. A place at r
/// from its centre has then moved by t + (R - I) r, which is linear in these twelve numbers.
using RegionMotion = Eigen::Matrix<double, 12, 1>;

inline RegionMotion region_motion(const Vec3& translation, const Vec3& rotation) {
  RegionMotion motion = RegionMotion::Zero();
  motion.head<3>() = translation;
  const double angle = rotation.norm();
  if (angle > 0.0) {
    const Eigen::Matrix3d turned =
        Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix() - Eigen::Matrix3d::Identity();
    motion.tail<9>() = turned.reshaped();
  }
  return motion;
}

/// R of a motion.
inline Eigen::Matrix3d rotation_of(const RegionMotion& motion) {
  return Eigen::Matrix3d::Identity() + motion.tail<9>().reshaped(3, 3);
}

/// What the twelve numbers do at a place r from the centre: 3 x 12.
inline Eigen::Matrix<double, 3, 12> motion_at(const Vec3& r) {
  Eigen::Matrix<double, 3, 12> at;
  at << Eigen::Matrix3d::Identity(), r[0] * Eigen::Matrix3d::Identity(), r[1] * Eigen::Matrix3d::Identity(),
      r[2] * Eigen::Matrix3d::Identity();
  return at;
}

/// The nodes that a probe holds and moves as one: a support of its body, and one that moves.
struct Region {
  std::vector<int> nodes{};  // mesh nodes, ascending
  bool alone = false;        // the body has no other support: it follows the region as a whole
  bool carries = false;  // and may be taken far: what faces what changes, and the body's frame turns with it

  Eigen::MatrixXd touch_motion{};  // of the touchable nodes of the unloaded body, 3t x 12
  Eigen::MatrixXf drawn_motion{};  // of the drawn nodes, 3d x 12
  /// Forces and torques (about the centre at rest) on each region of the body, in the order of its probes, that this
  /// region's motion takes, for E = 1 Pa: 6 x 12 each.
  std::vector<Eigen::Matrix<double, 6, 12>> reactions{};
};

}  // namespace palpate::sim
