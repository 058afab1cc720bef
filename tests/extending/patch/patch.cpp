#include "tests/extending/patch/patch.hpp"

#include <algorithm>
#include <set>

#include "sim/probe/mean/mean.hpp"

namespace palpate::sim {
namespace {

void hold(const ProbeSpec&, const TetMesh&, const Surface& surface, int middle, Probe& probe) {
  std::set<int> nodes;
  for (const Triangle& corners : surface.triangles)
    if (std::ranges::find(corners, middle) != corners.end()) nodes.insert(corners.begin(), corners.end());
  probe.nodes.assign(nodes.begin(), nodes.end());
  probe.weights.assign(nodes.size(), 1.0 / static_cast<double>(nodes.size()));
}

}  // namespace

constinit const ProbeKind kPatch{.keys = {.name = "patch",
                                          .meaning = "a node and its neighbours",
                                          .takes_radius = false,
                                          .holds_mean = true},
                                 .hold = hold,
                                 .prescribe = prescribe_mean};

}  // namespace palpate::sim
