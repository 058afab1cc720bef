#include "app/loop/force_guard.hpp"

#include <algorithm>
#include <cmath>

namespace palpate::app {

double guard_force(ForceGuard& guard, const GuardTimes& times, bool pose_is_finite, double input_age,
                   double force, double largest, double step) {
  if (!pose_is_finite || !std::isfinite(force)) guard.fault = Fault::NotFinite;
  const bool give = guard.fault == Fault::None && input_age <= times.longest_gap;
  guard.gain = give ? std::min(1.0, guard.gain + std::min(step, times.cycle) / times.ramp_up)
                    : std::max(0.0, guard.gain - step / times.ramp_down);
  // Once faulty the ramp goes on from the last good force: what is computed after a fault is not trusted.
  if (guard.fault == Fault::None) guard.last_finite_force = std::clamp(force, -largest, largest);
  return guard.gain * guard.last_finite_force;
}

}  // namespace palpate::app
