#pragma once

#include <optional>
#include <vector>

#include "sim/contact/exact/carried.hpp"
#include "sim/contact/frictional/coulomb.hpp"
#include "sim/model/contact_law.hpp"
#include "sim/pairing/facing_pairs.hpp"

namespace palpate::sim {

/// The contact model `exact` with Coulomb friction: what touches sticks until its friction is used up, and then slips.
/// A contact's memory is its anchor, three numbers: where its node would rest against the other body without friction,
/// in that body's frame, less where it stood at rest. While it sticks the anchor stays; while it slips, or is apart, the
/// anchor goes along. Each cycle is one implicit step: it depends on the pose and on the anchors alone.
extern const ContactLaw kFrictional;

struct FrictionalScratch : LawScratch {
  explicit FrictionalScratch(const Model& model);
  void reset() override;

  std::vector<FacingPair> pairs;
  std::optional<Carried> carried;   // where a region carries a body as a whole
  std::vector<int> near;            // contacts that can touch
  std::vector<double> normal_gaps;  // of each contact [m]
  std::vector<Vec3> gaps;           // likewise, with how far its sides stand from its anchor, in its frame
  std::vector<Vec3> went;           // of each contact's node against the other body, without what loads do
  std::vector<Vec3> anchors;        // what the memory is after the cycle
  FrictionSystem system;
  CoulombSolve solve;
  std::vector<char> holds;
  std::vector<double> values, given;  // of the probes' rows
};

}  // namespace palpate::sim
