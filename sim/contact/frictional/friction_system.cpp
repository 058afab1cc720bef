#include "sim/contact/frictional/friction_system.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "sim/contact/exact/contact_system.hpp"
#include "sim/contact/exact/coupling.hpp"
#include "sim/probe/probes.hpp"

namespace palpate::sim {
namespace {

void fill_with_probes(const Model& model, const ProbeRows& probes, const FacingPair& pair, Eigen::Index row,
                      const Eigen::Matrix3d& frame, FrictionSystem& system) {
  Eigen::Index column = 0;
  for (std::size_t p = 0; p < model.probes.size(); ++p) {
    const Probe& probe = model.probes[p];
    const bool joined = probe.body == pair.node_body || probe.body == pair.polygon_body;
    for (Eigen::Index axis = 0; axis < probe.axes.cols(); ++axis, ++column) {
      if (!joined) continue;
      const Vec3 apart = frame.transpose() *
                         relative_motion(pair, probe.body, compliance_of(probe, probes[p]).col(axis)) /
                         model.bodies[probe.body].young_modulus;
      system.compliance.block<3, 1>(row, column) = apart;
      system.compliance.block<1, 3>(column, row) = apart.transpose();
    }
  }
}

}  // namespace

Eigen::Matrix3d frame_of(const Vec3& normal) {
  Eigen::Index least = 0;
  normal.cwiseAbs().minCoeff(&least);
  Eigen::Matrix3d frame;
  frame.col(0) = normal;
  frame.col(1) = normal.cross(Vec3::Unit(least)).normalized();
  frame.col(2) = normal.cross(Vec3(frame.col(1)));
  return frame;
}

FrictionSystem empty_friction_system(const Model& model, std::size_t contacts) {
  const ContactSystem probes = empty_system(model, 0);
  const Eigen::Index size = probes.bilateral + 3 * static_cast<Eigen::Index>(contacts);
  FrictionSystem system{.compliance = Eigen::MatrixXd::Zero(size, size),
                        .bilateral = probes.bilateral,
                        .frames = std::vector<Eigen::Matrix3d>(contacts, Eigen::Matrix3d::Identity())};
  system.compliance.topLeftCorner(probes.bilateral, probes.bilateral) = probes.compliance;
  return system;
}

void fill_frictional(const Model& model, const ProbeRows& probes, std::span<const Eigen::Matrix3d> turns,
                     std::span<const FacingPair> pairs, std::span<const int> which, std::span<const int> with,
                     PushResponse& response, FrictionSystem& system) {
  for (const int i : which) system.frames[i] = frame_of(pairs[i].normal);
  for (const int i : which) {
    const Eigen::Index row = system.bilateral + 3 * i;
    fill_with_probes(model, probes, pairs[i], row, system.frames[i], system);
    respond(model, turns, pairs[i], response);
    for (const int j : with) {
      if (j < i && std::ranges::binary_search(which, j)) continue;  // both are of `which`: once is enough
      const Eigen::Index column = system.bilateral + 3 * j;
      const Eigen::Matrix3d block =
          system.frames[j].transpose() * coupling(turns, pairs[j], response) * system.frames[i];
      system.compliance.block<3, 3>(column, row) = block;
      system.compliance.block<3, 3>(row, column) = block.transpose();
    }
  }
}

void fill_probe_rows(const Model& model, const ProbeRows& probes, std::span<const FacingPair> pairs,
                     std::span<const int> contacts, FrictionSystem& system) {
  for (const int i : contacts)
    fill_with_probes(model, probes, pairs[i], system.bilateral + 3 * i, system.frames[i], system);
  write_between_probes(model, probes, system.compliance);
}

}  // namespace palpate::sim
