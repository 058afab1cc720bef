#include "devices/device/driven_probe.hpp"

namespace palpate::devices {

DrivenProbe probe_at(const Vec3& direction, double depth) {
  return {.direction = direction,
          .displacement = depth * direction,
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
  probe.hand = probe.depth = probe.displacement.dot(probe.direction);
}

}  // namespace palpate::devices
