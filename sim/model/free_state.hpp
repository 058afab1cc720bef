#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "sim/mesh/tet_mesh.hpp"
#include "sim/model/model.hpp"

namespace palpate::sim {

/// Where a probe is: its displacement from the place where it rests on the skin [m], and how it is turned there. It
/// presses while the displacement along the probe's direction is positive; otherwise it has left the skin and feels
/// nothing.
struct ProbeDisplacement {
  Vec3 from_rest = Vec3::Zero();
  Vec3 rotation = Vec3::Zero();  // rotation vector [rad]; of kinds that turn (ProbeKind::turns), else unused
};
using ProbeDisplacements = std::span<const ProbeDisplacement>;  // one a probe, in the model's order

/// What a probe prescribes in one cycle: W u = value along its axes, while it presses.
struct ProbeRow {
  RegionMotion region = RegionMotion::Zero();  // of a probe that holds a region

  // Of a probe that slides, where it is now, between three knots.
  Eigen::VectorXd weights{};     // in place of the probe's own
  Eigen::MatrixXd compliance{};  // likewise
  Vec3 shares = Vec3::Zero();    // of the knots, sum 1

  Vec3 value = Vec3::Zero();   // [m], one entry an axis: 3 when held, 1 when free
  Vec3 centre = Vec3::Zero();  // of a fingertip, where it is [m]
  std::array<int, 3> knots{};  // of a probe that slides
  bool pressing = false;
};
using ProbeRows = std::vector<ProbeRow>;  // one a probe

inline std::span<const double> weights_of(const Probe& probe, const ProbeRow& row) {
  if (probe.slide.knots.empty()) return probe.weights;
  return {row.weights.data(), static_cast<std::size_t>(row.weights.size())};
}
inline const Eigen::MatrixXd& compliance_of(const Probe& probe, const ProbeRow& row) {
  return probe.slide.knots.empty() ? probe.compliance : row.compliance;
}

/// How the touchable nodes of a body have moved before the bodies act on each other.
struct BodyMotion {
  Eigen::VectorXd displacement{};  // 3t [m]
  bool moved = false;              // false: at rest
};
using FreeMotion = std::vector<BodyMotion>;  // one a body

/// The bodies deformed by their probes alone: what a contact law starts from.
struct FreeState {
  ProbeRows probes{};
  FreeMotion motion{};
};

}  // namespace palpate::sim
