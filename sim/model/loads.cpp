#include "sim/model/loads.hpp"

#include <algorithm>

#include "sim/elasticity/finer_inside.hpp"
#include "sim/elasticity/static_solve.hpp"

namespace palpate::sim {

namespace {

/// Every node's vector turned.
template <class Vector>
auto turned(const Eigen::Matrix3d& turn, const Vector& vectors) {
  using Scalar = typename Vector::Scalar;
  return Eigen::Vector<Scalar, Eigen::Dynamic>(
      (turn.cast<Scalar>() * vectors.reshaped(3, vectors.size() / 3)).reshaped());
}

}  // namespace

Eigen::Matrix3d turn_of(const Model& model, int body, const Loads& loads) {
  for (const int probe : model.bodies[body].probes)
    if (const auto& region = model.probes[probe].region; region && region->carries)
      return rotation_of(loads.held[probe]);
  return Eigen::Matrix3d::Identity();
}

Eigen::VectorXd displacement(const Model& model, int index, const Loads& loads) {
  const Body& body = model.bodies[index];
  const Eigen::Matrix3d turn = turn_of(model, index, loads);
  const Eigen::VectorXd unit_loads =
      turned(turn.transpose(), Eigen::VectorXd(loads.on_body[index] / body.young_modulus));
  Eigen::VectorXd u = turned(turn, Eigen::VectorXd(body.compliance->touch_touch * unit_loads));
  for (const int probe : body.probes)
    if (model.probes[probe].region) u += model.probes[probe].region->touch_motion * loads.held[probe];
  return u;
}

Eigen::VectorXf deform(const Model& model, int index, const Loads& loads) {
  const Body& body = model.bodies[index];
  const Eigen::Matrix3d turn = turn_of(model, index, loads);
  const Eigen::VectorXf unit_loads =
      turned(turn.transpose(), Eigen::VectorXd(loads.on_body[index] / body.young_modulus)).cast<float>();
  Eigen::VectorXf u = turned(turn, Eigen::VectorXf(body.compliance->drawn_touch * unit_loads));
  for (const int probe : body.probes)
    if (model.probes[probe].region)
      u += model.probes[probe].region->drawn_motion * loads.held[probe].cast<float>();
  return u;
}

namespace {

/// Nodes that a body's supports prescribe, and where they have moved to.
struct Supported {
  std::vector<int> nodes{};         // ascending
  Eigen::Matrix3Xd displacement{};  // of every node of the mesh, 0 of the others
  bool as_a_whole = false;          // every node goes with them, and that takes no force
};

Supported supported(const Model& model, const Body& body, const FinerBody& finer, const Loads& loads) {
  Supported all{.nodes = body.fixed};
  all.displacement.setZero(3, std::ssize(finer.nodes));
  for (const int probe : body.probes) {
    const auto& region = model.probes[probe].region;
    if (!region) continue;
    const std::vector<int> held = with_added(finer, region->nodes);
    all.nodes.insert(all.nodes.end(), held.begin(), held.end());
    all.as_a_whole |= region->alone;
    for (int node = 0; node < std::ssize(finer.nodes); ++node)
      if (region->alone || std::ranges::binary_search(held, node))
        all.displacement.col(node) =
            motion_at(finer.nodes[node] - model.probes[probe].at) * loads.held[probe];
  }
  all.nodes = with_added(finer, std::move(all.nodes));
  std::ranges::sort(all.nodes);
  all.nodes.erase(std::unique(all.nodes.begin(), all.nodes.end()), all.nodes.end());
  return all;
}

}  // namespace

std::vector<WholeBody> whole_bodies(const Model& model, const Loads& loads) {
  std::vector<WholeBody> bodies;
  bodies.reserve(model.bodies.size());
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    WholeBody& whole = bodies.emplace_back();
    whole.force = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(body.mesh->nodes.size()));
    Eigen::Index entry = 0;
    for (const int node : body.compliance->touch) {
      whole.force.col(node) = loads.on_body[i].segment<3>(entry);
      entry += 3;
    }
    const Eigen::Matrix3d turn = turn_of(model, static_cast<int>(i), loads);
    const FinerBody finer = finer_inside(*body.mesh, body.materials, body.compliance->touch, body.interior);
    const Supported supports = supported(model, body, finer, loads);
    Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, std::ssize(finer.nodes));
    force.leftCols(whole.force.cols()) = turn.transpose() * whole.force;
    if (!supports.as_a_whole) force -= (finer.K * supports.displacement.reshaped()).reshaped(3, force.cols());
    whole.displacement = (turn * static_solve(finer.K, supports.nodes, force) + supports.displacement)
                             .leftCols(whole.force.cols());
  }
  return bodies;
}

}  // namespace palpate::sim
