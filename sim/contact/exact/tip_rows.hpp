#pragma once

#include <span>
#include <vector>

#include "sim/contact/exact/coupling.hpp"
#include "sim/contact/exact/system.hpp"
#include "sim/model/free_state.hpp"
#include "sim/model/model.hpp"
#include "sim/pairing/facing_pairs.hpp"

namespace palpate::sim {

/// Room for the rows of fingertips, which are others wherever these are.
struct TipRows {
  TipRows(const Model& model, std::size_t contacts);

  std::vector<int> near{};               // contacts below a sphere
  std::vector<int> with{};               // those and the ones between bodies that have rows
  std::vector<Eigen::Matrix3d> turns{};  // of bodies that stay where they are
  PushResponse response;
};

/// Whether a scene has a fingertip.
bool has_tips(const Model& model);

/// Appends a contact for each node that a fingertip may meet. @return where they begin
std::size_t add_tips(const Model& model, std::vector<FacingPair>& pairs);

/// Brings the rows of fingertips to where they are: gaps, and the system's rows with the contacts between bodies.
/// @param between_bodies  those that have rows, ascending
/// @param turns  of each body; empty: they stay
void bring_tips(const Model& model, const ProbeRows& probes, std::size_t first_tip,
                std::span<const int> between_bodies, std::span<const Eigen::Matrix3d> turns,
                std::span<FacingPair> pairs, std::span<double> gaps, TipRows& rows, ContactSystem& system);

}  // namespace palpate::sim
