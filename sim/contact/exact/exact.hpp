#pragma once

#include <optional>
#include <vector>

#include "sim/contact/exact/carried.hpp"
#include "sim/contact/exact/complementarity.hpp"
#include "sim/contact/exact/moving_rows.hpp"
#include "sim/contact/exact/tip_rows.hpp"
#include "sim/model/contact_law.hpp"
#include "sim/pairing/facing_pairs.hpp"

namespace palpate::sim {

/// Frictionless unilateral contact of all bodies, solved exactly on the compliance of all, the probes' rows in the
/// same system: no body enters another, contact only pushes, and it pushes only where the bodies touch. Gaps and
/// normals are those of the rest surfaces (small strain), so the problem is convex, has one solution and a potential.
extern const ContactLaw kExact;

/// Its solve, for a scratch that was made for the model.
SolveReport solve_exact(const Model& model, const FreeState& free, std::span<const double> memory,
                        LawScratch& scratch, Response& response);

/// Whether its system is a constant of the scene: no probe slides, touches from outside, or takes a body far.
bool rows_stay(const Model& model);

struct ExactScratch : LawScratch {
  /// @param bodies_touch  false: only what fingertips touch
  explicit ExactScratch(const Model& model, bool bodies_touch = true);
  void reset() override;

  std::vector<FacingPair> pairs;  // of bodies, then those of fingertips
  std::size_t first_tip = 0;      // where these begin
  std::optional<Carried>
      carried;            // where a region carries a body as a whole: it finds rows and gaps in every cycle
  std::vector<int> stay;  // contacts whose rows stay as they are, the first ones
  std::vector<double> rest_gaps;     // of each pair [m]
  std::vector<double> gaps;          // where regions have moved them [m]
  std::vector<RegionRows> regions;   // of each probe that holds one
  std::vector<SlidingRows> sliding;  // of each probe that slides
  std::optional<TipRows> tips;       // of fingertips, where the scene has some
  ContactSystem system;
  ComplementaritySolve solve;
  std::vector<char> holds;     // of each probe row
  std::vector<double> values;  // likewise [m]
  std::vector<double> given;   // forces that the contacts' own push takes from the probes [N]
};

}  // namespace palpate::sim
