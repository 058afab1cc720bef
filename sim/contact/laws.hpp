#pragma once

#include "sim/cycle/buffers.hpp"

namespace palpate::sim {

// A contact law takes the probe-only positions and the pairs found there (both in the buffers), asks nodes to
// move (BodyBuffers::actual_claims), and leaves it to apply_claims() to bring them there.

/// Sibille et al. 2002, as Kuroda et al. 2003 section 2 tells it: the colliding nodes of both bodies are
/// projected to the plane through their barycentre and perpendicular to their average normal. No stiffness
/// enters. Source: [Sibille2002].
SolveReport sibille(const Model& model, Scratch::Buffers& buffers);

/// Kuroda et al. 2003 section 3.3, equations (1)-(4), one pass. Source: [Kuroda2003]; choices:
/// docs/method.md.
SolveReport kuroda(const Model& model, Scratch::Buffers& buffers);

/// Moves the asked nodes while the probes hold: adds the forces that this takes to loads, displacement and
/// the probes' forces, and sums the contact forces of each pair of bodies.
SolveReport apply_claims(const Model& model, Scratch::Buffers& buffers);

}  // namespace palpate::sim
