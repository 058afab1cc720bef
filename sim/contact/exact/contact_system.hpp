#pragma once

#include <span>

#include "sim/contact/exact/coupling.hpp"
#include "sim/contact/exact/system.hpp"
#include "sim/model/free_state.hpp"
#include "sim/model/model.hpp"
#include "sim/pairing/facing_pairs.hpp"

namespace palpate::sim {

/// Room for so many contacts, their rows 0: first the rows of every probe's axes (in the model's order), then one of
/// each contact along its normal, on the compliance of all bodies: K = sum over bodies of J C J^T / E. What the probes'
/// rows do to each other stands.
ContactSystem empty_system(const Model& model, std::size_t contacts);

/// What the probes' rows do to each other where the probes are now, which is the first block of a system.
void write_between_probes(const Model& model, const ProbeRows& probes, Eigen::MatrixXd& compliance);

/// That, and what they take off the regions.
void fill_probes(const Model& model, const ProbeRows& probes, ContactSystem& system);

/// Rows and columns of some of the contacts, with others and with the probes.
/// @param turns  of each body: the rotation of its frame
/// @param which, with  contacts, by index into `pairs`, ascending; `with` holds all of `which`
void fill_contacts(const Model& model, const ProbeRows& probes, std::span<const Eigen::Matrix3d> turns,
                   std::span<const FacingPair> pairs, std::span<const int> which, std::span<const int> with,
                   PushResponse& response, ContactSystem& system);

/// How a motion of the touchable nodes of a body, 3t, opens a gap.
double opened_by(const FacingPair& pair, int body, const Eigen::Ref<const Eigen::VectorXd>& motion);

}  // namespace palpate::sim
