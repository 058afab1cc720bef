#include "sim/contact/prescribed/prescribed_law.hpp"

namespace palpate::sim {

PrescribedScratch::PrescribedScratch(const Model& model) : placement(rest_placement(model)) {
  summaries.resize(model.pairs.size());
  pairs.reserve(most_pairs(model));
  bodies.reserve(model.bodies.size());
  for (int i = 0; i < std::ssize(model.bodies); ++i)
    bodies.push_back({contact_solve(model, i), Claims(model.bodies[i].compliance->touch.size())});
}

PrescribedSolve contact_solve(const Model& model, int body) {
  return {model, body, static_cast<int>(model.bodies[body].colliding_nodes.size())};
}

void hold_probed_nodes(const Model& model, const ProbeRows& probes, int body, Claims& claims) {
  for (const int probe : model.bodies[body].probes)
    if (probes[probe].pressing)
      claims.hold(model.probes[probe].nodes, weights_of(model.probes[probe], probes[probe]));
}

bool find_contacts(const Model& model, const FreeState& free, PrescribedScratch& scratch) {
  place(model, free.motion, scratch.placement);
  find_pairs(model, free.motion, scratch.placement, scratch.pairs);
  for (const CollidingPair& pair : scratch.pairs) ++scratch.summaries[pair.touch_pair].active;
  if (scratch.pairs.empty()) return false;
  for (int i = 0; i < std::ssize(model.bodies); ++i) {
    Claims& claims = scratch.bodies[i].claims;
    claims.clear();
    hold_probed_nodes(model, free.probes, i, claims);
  }
  return true;
}

}  // namespace palpate::sim
