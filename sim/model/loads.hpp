#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/model/model.hpp"

namespace palpate::sim {

/// Nodal forces on the touchable nodes of each body [N], 3t entries each, the probes' included, and how far the
/// regions that probes hold have moved.
struct Loads {
  std::vector<Eigen::VectorXd> on_body{};
  std::vector<RegionMotion> held{};  // one a probe, 0 of those that hold no region
};

/// How a body that follows a region as a whole is turned; else I.
Eigen::Matrix3d turn_of(const Model& model, int body, const Loads& loads);

/// Displacements of the touchable nodes of a body under loads, R C R^T f / E and what the regions bring, 3t [m].
Eigen::VectorXd displacement(const Model& model, int body, const Loads& loads);

/// What the bodies have come to in a cycle: first by the probes alone, then with what a contact law adds.
struct Response {
  Loads loads{};
  std::vector<Vec3> probe_forces{};   // of each probe on its body [N]
  std::vector<Vec3> probe_torques{};  // of those that hold a region, about where its centre is [N m]
};

/// Displacements of the drawn nodes of a body under loads [m], 3d entries, for frames. Outside the cycle.
Eigen::VectorXf deform(const Model& model, int body, const Loads& loads);

/// A whole body under loads, 3 x n each.
struct WholeBody {
  Eigen::Matrix3Xd force{};         // on each node [N]
  Eigen::Matrix3Xd displacement{};  // of each node [m]
};
/// Of each body, by the uncondensed problem: slow, for pictures and files.
std::vector<WholeBody> whole_bodies(const Model& model, const Loads& loads);

}  // namespace palpate::sim
