#include "sim/cost/press_poses.hpp"

#include "sim/cycle/press.hpp"
#include "sim/pairing/find_pairs.hpp"

namespace palpate::sim {
namespace {

/// Whether the bodies, moved by the probes alone, have come together: whatever contact model then works.
bool bodies_touch(const Model& model, ProbeDisplacements probes, Simulation& alone, Placement& placement) {
  alone.step(probes, kCyclePeriod);
  const FreeMotion motion = alone.motion();
  place(model, motion, placement);
  Pairs pairs;
  find_pairs(model, motion, placement, pairs);
  return !pairs.empty();
}

}  // namespace

std::vector<PressPose> poses_to_time(const Model& model, const CycleSampling& sampling, Simulation& alone,
                                     bool& touching) {
  std::vector<PressPose> all, together;
  Placement placement = rest_placement(model);
  for (int step = 1; step <= sampling.poses; ++step) {
    const double depth = sampling.depth * step / sampling.poses;
    all.push_back({depth, displaced_by(model, depth)});
    if (bodies_touch(model, all.back().probes, alone, placement)) together.push_back(all.back());
  }
  touching = !together.empty();
  return touching ? together : all;
}

std::size_t to_and_fro(int cycle_number, std::size_t poses) {
  if (poses == 1) return 0;
  const std::size_t at = static_cast<std::size_t>(cycle_number) % (2 * poses - 2);
  return at < poses ? at : 2 * poses - 2 - at;
}

Model with_law(Model model, const ContactLaw& law) {
  model.law = &law;
  return model;
}

}  // namespace palpate::sim
