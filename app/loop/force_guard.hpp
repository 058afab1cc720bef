#pragma once

#include <cstdint>

namespace palpate::app {

enum class Fault : std::uint8_t { None, NotFinite };

/// What stands between the simulation and the hand: the delivered force is `gain` times the computed one. A
/// fault takes the gain to zero along one ramp of at most 20 ms and latches: the interval is over, and the
/// next one has a guard of its own. A gap in the input takes it there too, but it comes back, slowly, when
/// the hand does.
struct ForceGuard {
  double gain = 1.0;               // [-], 0 to 1
  Fault fault = Fault::None;       // latched
  double last_finite_force = 0.0;  // [N]: what the ramp starts from when the computed force is no number
};

struct GuardTimes {
  double longest_gap = 0.1;  // input older than this counts as a gap [s]
  double ramp_down = 0.015;  // [s], within the 20 ms that every backend keeps
  double ramp_up = 0.1;      // [s]
  double cycle = 1e-3;       // what rises does so by one cycle at a time, however late the loop is [s]
};

/// One cycle of the guard: the force to deliver [N], always finite.
/// @param pose_is_finite  whether what the device reports is a number
/// @param input_age       time since the newest input [s]
/// @param force           as computed [N]
/// @param largest         the device's continuous limit, > 0 [N]
/// @param step            time since the last cycle [s]
double guard_force(ForceGuard& guard, const GuardTimes& times, bool pose_is_finite, double input_age,
                   double force, double largest, double step);

}  // namespace palpate::app
