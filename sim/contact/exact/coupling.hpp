#pragma once

#include <Eigen/Core>
#include <span>

#include "sim/model/model.hpp"
#include "sim/pairing/facing_pairs.hpp"

namespace palpate::sim {

/// How a motion of the touchable nodes of a body, 3t, takes the two sides of a contact apart.
Vec3 relative_motion(const FacingPair& pair, int body, Eigen::Ref<const Eigen::VectorXd> motion);

/// How far the two sides of one contact move apart per newton that pushes those of another apart, 3 x 3 [m/N], in
/// space: the block of sum over bodies of J C J^T / E before it is taken along normals.
/// @param turns  of each body: the rotation of its frame
Eigen::Matrix3d coupling(const Model& model, std::span<const Eigen::Matrix3d> turns,
                         const FacingPair& measured, const FacingPair& pushed);

}  // namespace palpate::sim
