#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "sim/model/model.hpp"
#include "sim/pairing/facing_pairs.hpp"

namespace palpate::sim {

/// How a motion of the touchable nodes of a body, 3t, takes the two sides of a contact apart.
Vec3 relative_motion(const FacingPair& pair, int body, const Eigen::Ref<const Eigen::VectorXd>& motion);

/// What forces of 1 N that push the two sides of one contact apart do to the two bodies, each in its own frame.
struct PushResponse {
  /// Room for any contact of a model.
  explicit PushResponse(const Model& model);

  std::array<int, 2> bodies{};
  std::array<Eigen::Matrix<double, Eigen::Dynamic, 3>, 2>
      displaced{};  // of the touchable nodes, of each direction [m/N]
};

/// @param turns  of each body: the rotation of its frame
void respond(const Model& model, std::span<const Eigen::Matrix3d> turns, const FacingPair& pushed,
             PushResponse& response);

/// How far the two sides of one contact move apart per newton of another's push, 3 x 3 [m/N], in space: the block of
/// sum over bodies of J C J^T / E before it is taken along normals.
Eigen::Matrix3d coupling(std::span<const Eigen::Matrix3d> turns, const FacingPair& measured,
                         const PushResponse& response);

}  // namespace palpate::sim
