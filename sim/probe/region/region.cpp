#include "sim/probe/region/region.hpp"

namespace palpate::sim {
namespace {

void prescribe_region(const Probe&, const ProbeDisplacement& displacement, ProbeRow& row) {
  row.region = region_motion(displacement.from_rest, displacement.rotation);
}

}  // namespace

constinit const ProbeKind kRegion{
    .keys = {.name = "region",
             .meaning =
                 "a named group of the mesh, held and moved as one; it may be all that holds its body, and "
                 "then take it far where it has a `reach`",
             .takes_reach = true,
             .takes_group = true},
    .turns = true,
    .prescribe = prescribe_region};

}  // namespace palpate::sim
