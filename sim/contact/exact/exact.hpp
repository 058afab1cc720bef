#pragma once

#include <vector>

#include "sim/contact/exact/complementarity.hpp"
#include "sim/model/contact_law.hpp"
#include "sim/pairing/facing_pairs.hpp"

namespace palpate::sim {

/// Frictionless unilateral contact of all bodies, solved exactly on the compliance of all, the probes' rows in the
/// same system: no body enters another, contact only pushes, and it pushes only where the bodies touch. Gaps and
/// normals are those of the rest surfaces (small strain), so the problem is convex, has one solution and a potential.
extern const ContactLaw kExact;

struct ExactScratch : LawScratch {
  explicit ExactScratch(const Model& model);
  void reset() override { solve.reset(); }

  std::vector<FacingPair> pairs;
  std::vector<double> gaps;  // of each pair at rest [m]
  ContactSystem system;
  ComplementaritySolve solve;
  std::vector<char> holds;     // of each probe row
  std::vector<double> values;  // likewise [m]
  std::vector<double> given;   // forces that the contacts' own push takes from the probes [N]
};

}  // namespace palpate::sim
