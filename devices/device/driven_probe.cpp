#include "devices/device/driven_probe.hpp"

namespace palpate::devices {

DrivenProbe probe_at(const Vec3& direction, double depth, double deepest) {
  return {.direction = direction,
          .displacement = depth * direction,
          .deepest = deepest,
          .hand = depth,
          .depth = depth,
          .previous_depth = depth};
}

void hold_probe(DrivenProbe& probe, const Vec3& target, double step) {
  const Vec3 way = target - probe.displacement;
  const double length = way.norm(), reach = kLargestHandSpeed * step;
  if (length <= reach)
    probe.displacement = target;
  else
    probe.displacement += reach / length * way;
  const double beyond = probe.displacement.dot(probe.direction) - probe.deepest;
  if (beyond > 0.0) probe.displacement -= beyond * probe.direction;
  probe.hand = probe.depth = probe.displacement.dot(probe.direction);
}

}  // namespace palpate::devices
