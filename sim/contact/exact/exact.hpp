#pragma once

#include <optional>
#include <vector>

#include "sim/contact/exact/carried.hpp"
#include "sim/contact/exact/complementarity.hpp"
#include "sim/contact/exact/moving_rows.hpp"
#include "sim/model/contact_law.hpp"
#include "sim/pairing/facing_pairs.hpp"

namespace palpate::sim {

/// Frictionless unilateral contact of all bodies, solved exactly on the compliance of all, the probes' rows in the
/// same system: no body enters another, contact only pushes, and it pushes only where the bodies touch. Gaps and
/// normals are those of the rest surfaces (small strain), so the problem is convex, has one solution and a potential.
extern const ContactLaw kExact;

struct ExactScratch : LawScratch {
  explicit ExactScratch(const Model& model);
  void reset() override;

  std::vector<FacingPair> pairs;
  std::optional<Carried>
      carried;  // where a region carries a body as a whole: it finds rows and gaps in every cycle
  std::vector<double> rest_gaps;     // of each pair [m]
  std::vector<double> gaps;          // where regions have moved them [m]
  std::vector<RegionRows> regions;   // of each probe that holds one
  std::vector<SlidingRows> sliding;  // of each probe that slides
  ContactSystem system;
  ComplementaritySolve solve;
  std::vector<char> holds;     // of each probe row
  std::vector<double> values;  // likewise [m]
  std::vector<double> given;   // forces that the contacts' own push takes from the probes [N]
};

}  // namespace palpate::sim
