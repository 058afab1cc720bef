#include "sim/compile/region.hpp"

#include <Eigen/SparseCore>
#include <algorithm>

#include "sim/elasticity/finer_inside.hpp"
#include "sim/elasticity/supported_stiffness.hpp"

namespace palpate::sim {
namespace {

using Modes = Eigen::Matrix<double, Eigen::Dynamic, 12>;  // 3n x 12

/// What a region's motion does to its own nodes; 0 elsewhere. Where nothing else holds the body, what it does to all.
Modes prescribed(const FinerBody& finer, const Probe& probe) {
  const auto n = std::ssize(finer.nodes);
  const std::vector<int> held = with_added(finer, probe.region->nodes);
  Modes modes = Modes::Zero(3 * n, 12);
  for (int node = 0; node < n; ++node)
    if (probe.region->alone || std::ranges::binary_search(held, node))
      modes.middleRows<3>(3 * node) = motion_at(finer.nodes[node] - probe.at);
  return modes;
}

/// The other nodes follow, without loads on them.
void let_follow(const Eigen::SparseMatrix<double>& K, const SupportedStiffness& supported, Modes& modes) {
  const Modes taken = K * modes;
  const std::vector<int>& order = supported.order();
  Eigen::MatrixXd right(3 * std::ssize(order), 12);
  for (std::size_t place = 0; place < order.size(); ++place)
    right.middleRows<3>(static_cast<Eigen::Index>(3 * place)) = -taken.middleRows<3>(3 * order[place]);
  const Eigen::MatrixXd moved = supported.solve(right);
  for (std::size_t place = 0; place < order.size(); ++place)
    modes.middleRows<3>(3 * order[place]) = moved.middleRows<3>(static_cast<Eigen::Index>(3 * place));
}

/// Force and torque on a region, of the forces on all nodes.
Eigen::Matrix<double, 6, 12> wrench(const FinerBody& finer, const Probe& probe, const Modes& forces) {
  Eigen::Matrix<double, 6, 12> sum = Eigen::Matrix<double, 6, 12>::Zero();
  for (const int node : with_added(finer, probe.region->nodes)) {
    const Vec3 arm = finer.nodes[node] - probe.at;
    for (Eigen::Index mode = 0; mode < 12; ++mode) {
      const Vec3 force = forces.col(mode).segment<3>(3 * node);
      sum.col(mode).head<3>() += force;
      sum.col(mode).tail<3>() += arm.cross(force);
    }
  }
  return sum;
}

Eigen::MatrixXd rows_of(const Modes& modes, const std::vector<int>& nodes) {
  Eigen::MatrixXd rows(3 * std::ssize(nodes), 12);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    rows.middleRows<3>(static_cast<Eigen::Index>(3 * i)) = modes.middleRows<3>(3 * nodes[i]);
  return rows;
}

std::vector<int> held_nodes(const Body& body, const FinerBody& finer, std::span<const Probe> probes) {
  std::vector<int> held = body.fixed;
  for (const Probe& probe : probes)
    if (probe.region) held.insert(held.end(), probe.region->nodes.begin(), probe.region->nodes.end());
  held = with_added(finer, std::move(held));
  std::ranges::sort(held);
  return held;
}

}  // namespace

void finish_regions(const Body& body, std::span<Probe> probes) {
  if (std::ranges::none_of(probes, [](const Probe& probe) { return probe.region != nullptr; })) return;
  std::vector<Material> unit = body.materials;
  for (Material& material : unit) material.young_modulus /= body.young_modulus;
  const FinerBody finer = finer_inside(*body.mesh, unit, body.compliance->touch, body.interior);
  const Eigen::SparseMatrix<double>& K = finer.K;
  const SupportedStiffness supported(K, held_nodes(body, finer, probes));
  for (Probe& probe : probes) {
    if (!probe.region) continue;
    Region region = *probe.region;
    Modes modes = prescribed(finer, probe);
    if (!region.alone) let_follow(K, supported, modes);
    region.touch_motion = rows_of(modes, body.compliance->touch);
    region.drawn_motion = rows_of(modes, body.compliance->drawn).cast<float>();
    Modes forces = Modes::Zero(modes.rows(), 12);
    if (!region.alone) forces = K * modes;
    for (const Probe& other : probes)
      if (other.region) region.reactions.push_back(wrench(finer, other, forces));
    probe.region = std::make_shared<const Region>(std::move(region));
  }
}

}  // namespace palpate::sim
