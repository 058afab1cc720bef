#pragma once

#include <limits>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::devices {

using sim::Vec3;

constexpr double kLargestHandSpeed = 0.5;  // a hand that jumps is followed no faster than this [m/s]

/// The probe that a hand moves, and the hand as it is followed. The engine of an interval owns it; the device
/// in use moves it on.
struct DrivenProbe {
  Vec3 direction = Vec3::UnitZ();    // of the press, into the tissue, unit length
  Vec3 displacement = Vec3::Zero();  // of the probe from where it rests [m]
  /// Where the scene's press ends, along it [m].
  double deepest = std::numeric_limits<double>::infinity();
  double hand = 0.0;            // along the press [m]
  double depth = 0.0;           // x: of the probe, along the press [m]
  double previous_depth = 0.0;  // where the force was known before [m]
  double previous_force = 0.0;  // [N]
};

/// A probe that rests at `depth` along the press, and the hand with it; it goes no further than `deepest`.
DrivenProbe probe_at(const Vec3& direction, double depth, double deepest);

/// The probe is where the hand is, as far as the largest speed and the scene's depth let it: for a device that
/// pushes back, or whose path is the probe's.
/// @param target  where the hand is, from where the probe rests [m]
/// @param step    since the last move [s]
void hold_probe(DrivenProbe& probe, const Vec3& target, double step);

}  // namespace palpate::devices
