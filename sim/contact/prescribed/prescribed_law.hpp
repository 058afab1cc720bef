#pragma once

#include <vector>

#include "sim/contact/prescribed/claims.hpp"
#include "sim/contact/prescribed/prescribed_solve.hpp"
#include "sim/model/contact_law.hpp"
#include "sim/pairing/find_pairs.hpp"

namespace palpate::sim {

// Laws that prescribe displacements: they find the pairs at the probe-only positions, ask nodes to move, and
// leave it to apply_claims() to bring them there.

/// What such a law asks of one body, and the solve that brings it there.
struct ClaimedBody {
  PrescribedSolve solve;
  Claims claims;
};

struct PrescribedScratch : LawScratch {
  explicit PrescribedScratch(const Model& model);

  Placement placement;
  Pairs pairs;
  std::vector<ClaimedBody> bodies;
};

/// Room to prescribe the displacements of every node of a body that can collide.
PrescribedSolve contact_solve(const Model& model, int body);

/// Keeps the claims from nodes that a pressing probe of the body holds.
void hold_probed_nodes(const Model& model, const ProbeRows& probes, int body, Claims& claims);

/// Begins a cycle: places the surfaces, finds and counts the pairs, and empties the claims.
/// @return false where nothing touches
bool find_contacts(const Model& model, const FreeState& free, PrescribedScratch& scratch);

/// Moves the asked nodes while the probes hold: adds the forces that this takes to the response, and sums the
/// contact forces of each pair of bodies.
SolveReport apply_claims(const Model& model, const FreeState& free, PrescribedScratch& scratch,
                         Response& response);

}  // namespace palpate::sim
