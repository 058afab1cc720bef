#pragma once

#include "devices/device/driven_probe.hpp"

namespace palpate::devices {

/// What joins the hand to the probe where no device can push back: a virtual spring. The pointer is drawn at
/// the probe, so that stiffer tissue leaves it further behind the hand; that lag is the declared channel of a
/// pseudo-haptic session. Source: [Lecuyer2009]. The constants are the same for every condition and model.
/// The spring is near the stiffness of the palpated wall (41.8 N at 5 mm over the soft prostate): the lag
/// tells most of a tissue whose stiffness is the spring's.
struct PseudoHapticCoupling {
  double spring = 10e3;                           // k_c [N/m]
  double lag_time = 0.010;                        // tau [s]: how soon the probe follows a free hand
  double largest_hand_speed = kLargestHandSpeed;  // [m/s]
};

/// Moves hand and depth along the press: the hand towards `target`, the probe by one step of
/// tau x' = (h - x) - F(x)/k_c, whose rest point is the spring's equilibrium k_c (h - x) = F(x). The step is
/// implicit in the tissue's stiffness, for which the larger of the secants to rest and to the last depth is
/// taken: with K that stiffness an error shrinks by 1/(1 + (dt/tau)(1 + K/k_c)) a step, which is below 1 for
/// every K >= 0, as long as the tissue is no stiffer ahead than K; where it stiffens at once (a second body is
/// met), one step may go too far. No deeper than the scene's depth. `probe.displacement` is left alone.
/// @param target  where the hand is [m]
/// @param force   F at probe.depth, against the press [N]
/// @param step    dt [s]
void follow_hand(const PseudoHapticCoupling& coupling, DrivenProbe& probe, double target, double force,
                 double step);

}  // namespace palpate::devices
