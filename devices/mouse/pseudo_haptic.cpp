#include "devices/mouse/pseudo_haptic.hpp"

#include <algorithm>
#include <cmath>

namespace palpate::devices {
namespace {

constexpr double kSmallestMove = 1e-8;  // [m]; a difference quotient over less is rounding

/// The tissue's stiffness as far as the last two forces tell [N/m], never negative.
double secant_stiffness(const DrivenProbe& probe, double force) {
  double stiffness = probe.depth > 0 && force > 0 ? force / probe.depth : 0.0;
  const double move = probe.depth - probe.previous_depth;
  if (std::abs(move) > kSmallestMove) stiffness = std::max(stiffness, (force - probe.previous_force) / move);
  return stiffness;
}

}  // namespace

void follow_hand(const PseudoHapticCoupling& coupling, DrivenProbe& probe, double target, double force,
                 double step) {
  const double reach = coupling.largest_hand_speed * step;
  probe.hand += std::clamp(target - probe.hand, -reach, reach);

  const double a = step / coupling.lag_time;
  const double stiffness = secant_stiffness(probe, force);
  const double pull = probe.hand - probe.depth - force / coupling.spring;
  probe.previous_depth = probe.depth;
  probe.previous_force = force;
  probe.depth += a * pull / (1 + a * (1 + stiffness / coupling.spring));
  probe.depth = std::min(probe.depth, probe.deepest);
}

}  // namespace palpate::devices
