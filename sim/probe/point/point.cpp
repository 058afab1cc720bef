#include "sim/probe/point/point.hpp"

#include "sim/probe/mean/mean.hpp"

namespace palpate::sim {
namespace {

void hold_one_node(const ProbeSpec&, const TetMesh&, const Surface&, int middle, Probe& probe) {
  probe.nodes = {middle};
  probe.weights = {1.0};
}

}  // namespace

constinit const ProbeKind kPoint{
    .keys = {.name = "point",
             .meaning = "one node of the mesh, as the manipulating point of Kuroda et al. 2003",
             .takes_radius = false,
             .holds_mean = true},
    .hold = hold_one_node,
    .prescribe = prescribe_mean};

}  // namespace palpate::sim
