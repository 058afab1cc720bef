#pragma once

#include <vector>

#include "sim/contact/prescribed/prescribed_law.hpp"

namespace palpate::sim {

/// What the shares of a pair are made of: |f_B| and |f_A| of equations (3) and (4).
struct PairShare {
  double polygon_force = 0.0;  // |f| on the polygon [N]
  double node_force = 0.0;     // |f| on the polygon beside the node [N]
};

/// Step 3 of the paper for one body: temporary deformation, the other taken as rigid.
struct TemporaryBody {
  PrescribedSolve solve;
  Claims claims;
  Eigen::VectorXd forces;  // for E of the body, 3t [N]
};

struct KurodaScratch
    : PrescribedScratch {  // whose solves and claims are those of step 5: actual displacements
  explicit KurodaScratch(const Model& model);

  std::vector<TemporaryBody> temporary;
  std::vector<int> beside;        // of each of `pairs`: the polygon of A beside a
  std::vector<PairShare> shares;  // of each of `pairs`
};

/// Kuroda et al. 2003 section 3.3, equations (1)-(4), one pass. Its scratch is a KurodaScratch.
/// Source: [Kuroda2003]; choices: docs/method.md.
extern const ContactLaw kKuroda;

}  // namespace palpate::sim
