#pragma once

#include "sim/contact/prescribed.hpp"
#include "sim/cycle/cycle.hpp"
#include "sim/pairing/find_pairs.hpp"
#include "sim/probe/footprint.hpp"

namespace palpate::sim {

/// What a contact model needs of one body while it works.
struct BodyBuffers {
  PrescribedSolve free;       // the probes alone
  PrescribedSolve temporary;  // step 3 of the paper: temporary deformation
  PrescribedSolve actual;     // step 5: actual displacements
  Claims temporary_claims;
  Claims actual_claims;
  Eigen::VectorXd temporary_forces;  // for E of the body, 3t [N]
};

/// What the shares of a pair are made of: |f_B| and |f_A| of equations (3) and (4).
struct PairShare {
  double polygon_force = 0.0;  // |f| on the polygon [N]
  double node_force = 0.0;     // |f| on the polygon beside the node [N]
};

struct Scratch::Buffers {
  explicit Buffers(const Model& model);

  ProbeRows rows;
  FreeMotion free_motion;
  Pairs pairs;
  std::vector<PairShare> shares;  // of `pairs`, filled by kuroda
  std::vector<BodyBuffers> bodies;
  std::vector<Eigen::VectorXd> displacement;
  Loads loads;
  std::vector<Vec3> probe_forces;
  std::vector<PairSummary> summaries;
};

/// Probe-only positions: every body deformed by the probes that press it and nothing else. Fills free_motion,
/// loads, displacement and the probes' forces on the bodies.
SolveReport free_deformation(const Model& model, Scratch::Buffers& buffers);

}  // namespace palpate::sim
