#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "sim/contact/exact/coupling.hpp"
#include "sim/model/free_state.hpp"
#include "sim/model/model.hpp"
#include "sim/pairing/facing_pairs.hpp"

namespace palpate::sim {

/// Contacts and probes as one system, three rows a contact: along its normal and along two tangents.
struct FrictionSystem {
  Eigen::MatrixXd compliance{};  // K [m/N], symmetric, positive semidefinite; the axes of all probes first
  Eigen::Index bilateral = 0;    // rows of probes
  std::vector<Eigen::Matrix3d> frames{};  // of each contact, in space: columns normal, tangent, tangent
};

/// A normal and two tangents, columns; a function of the normal alone.
Eigen::Matrix3d frame_of(const Vec3& normal);

/// Room for so many contacts; what the probes' rows do to each other stands.
FrictionSystem empty_friction_system(const Model& model, std::size_t contacts);

/// Frames, and rows and columns of some of the contacts with others and with the probes.
/// @param turns  of each body: the rotation of its frame
/// @param which, with  contacts, by index into `pairs`, ascending; `with` holds all of `which`
void fill_frictional(const Model& model, const ProbeRows& probes, std::span<const Eigen::Matrix3d> turns,
                     std::span<const FacingPair> pairs, std::span<const int> which, std::span<const int> with,
                     PushResponse& response, FrictionSystem& system);

/// The same for what the probes' rows do to each other and to the contacts, where the probes are now.
void fill_probe_rows(const Model& model, const ProbeRows& probes, std::span<const FacingPair> pairs,
                     std::span<const int> contacts, FrictionSystem& system);

}  // namespace palpate::sim
