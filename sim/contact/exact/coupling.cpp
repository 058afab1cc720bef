#include "sim/contact/exact/coupling.hpp"

#include <array>

namespace palpate::sim {
namespace {

/// The nodes of one body that a contact joins, with their weights: + of its node, - of its polygon.
struct Side {
  int count = 0;
  std::array<int, 3> nodes{};
  std::array<double, 3> weights{};
};

Side side_on(const FacingPair& pair, int body) {
  if (pair.node_body == body) return {1, {pair.node}, {1.0}};
  if (pair.polygon_body == body)
    return {3, pair.corners, {-pair.weights[0], -pair.weights[1], -pair.weights[2]}};
  return {};
}

void add_body(const Model& model, const Eigen::Matrix3d& turn, int index, const FacingPair& measured,
              const FacingPair& pushed, Eigen::Matrix3d& sum) {
  const Side to = side_on(measured, index), from = side_on(pushed, index);
  if (to.count == 0 || from.count == 0) return;
  const Body& body = model.bodies[index];
  Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
  for (std::size_t b = 0; b < static_cast<std::size_t>(from.count); ++b)
    for (std::size_t a = 0; a < static_cast<std::size_t>(to.count); ++a)
      block += to.weights[a] * from.weights[b] *
               body.compliance->touch_touch.block<3, 3>(3 * to.nodes[a], 3 * from.nodes[b]);
  sum += 1.0 / body.young_modulus * turn * block * turn.transpose();
}

}  // namespace

Vec3 relative_motion(const FacingPair& pair, int body, Eigen::Ref<const Eigen::VectorXd> motion) {
  Vec3 apart = Vec3::Zero();
  if (pair.node_body == body) apart += motion.segment<3>(3 * pair.node);
  if (pair.polygon_body == body)
    for (std::size_t k = 0; k < 3; ++k)
      apart -= pair.weights[static_cast<Eigen::Index>(k)] * motion.segment<3>(3 * pair.corners[k]);
  return apart;
}

Eigen::Matrix3d coupling(const Model& model, std::span<const Eigen::Matrix3d> turns,
                         const FacingPair& measured, const FacingPair& pushed) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  add_body(model, turns[measured.node_body], measured.node_body, measured, pushed, sum);
  add_body(model, turns[measured.polygon_body], measured.polygon_body, measured, pushed, sum);
  return sum;
}

}  // namespace palpate::sim
