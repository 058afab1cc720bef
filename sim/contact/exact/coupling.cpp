#include "sim/contact/exact/coupling.hpp"

#include <algorithm>

namespace palpate::sim {
namespace {

/// The nodes of one body that a contact joins, with their weights: + of its node, - of its polygon.
struct Side {
  std::size_t count = 0;
  std::array<int, 3> nodes{};
  std::array<double, 3> weights{};
};

Side side_on(const FacingPair& pair, int body) {
  if (pair.node_body == body) return {1, {pair.node}, {1.0}};
  if (pair.polygon_body == body)
    return {3, pair.corners, {-pair.weights[0], -pair.weights[1], -pair.weights[2]}};
  return {};
}

}  // namespace

Vec3 relative_motion(const FacingPair& pair, int body, const Eigen::Ref<const Eigen::VectorXd>& motion) {
  Vec3 apart = Vec3::Zero();
  if (pair.node_body == body) apart += motion.segment<3>(3 * pair.node);
  if (pair.polygon_body == body)
    for (std::size_t k = 0; k < 3; ++k)
      apart -= pair.weights[static_cast<Eigen::Index>(k)] * motion.segment<3>(3 * pair.corners[k]);
  return apart;
}

PushResponse::PushResponse(const Model& model) {
  Eigen::Index most = 0;
  for (const Body& body : model.bodies) most = std::max(most, body.compliance->touch_touch.rows());
  for (auto& nodes : displaced) nodes.setZero(most, 3);
}

void respond(const Model& model, std::span<const Eigen::Matrix3d> turns, const FacingPair& pushed,
             PushResponse& response) {
  response.bodies = {pushed.node_body, pushed.polygon_body};
  for (std::size_t side = 0; side < 2; ++side) {
    const int index = response.bodies[side];
    if (index == kRigid) continue;
    const Body& body = model.bodies[index];
    const Side from = side_on(pushed, index);
    const Eigen::Matrix3d into = turns[index].transpose() / body.young_modulus;
    auto displaced = response.displaced[side].topRows(body.compliance->touch_touch.rows());
    displaced.setZero();
    for (std::size_t k = 0; k < from.count; ++k) {
      const auto columns = body.compliance->touch_touch.middleCols<3>(3 * from.nodes[k]);
      for (Eigen::Index to = 0; to < 3; ++to)
        for (Eigen::Index axis = 0; axis < 3; ++axis)
          if (const double by = from.weights[k] * into(axis, to); by != 0.0)
            displaced.col(to) += by * columns.col(axis);
    }
  }
}

Eigen::Matrix3d coupling(std::span<const Eigen::Matrix3d> turns, const FacingPair& measured,
                         const PushResponse& response) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::size_t side = 0; side < 2; ++side) {
    if (response.bodies[side] == kRigid) continue;
    const Side to = side_on(measured, response.bodies[side]);
    if (to.count == 0) continue;
    Eigen::Matrix3d apart = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < to.count; ++k)
      apart += to.weights[k] * response.displaced[side].middleRows<3>(3 * to.nodes[k]);
    sum += turns[response.bodies[side]] * apart;
  }
  return sum;
}

}  // namespace palpate::sim
