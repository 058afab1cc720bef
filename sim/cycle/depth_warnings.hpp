#pragma once

#include <string>
#include <vector>

#include "sim/model/loads.hpp"
#include "sim/model/model.hpp"

namespace palpate::sim {

/// Where a line from what a probe holds, along its press, leaves the probe's body at rest.
struct FarSide {
  double distance = 0.0;  // [m], infinite where it never does, as for a probe that pulls
  Triangle triangle{};    // there
};
FarSide far_side(const Model& model, const Probe& probe);

/// Why a press of a probe to this depth [m] shows more than the scene is made for: a sentence where it goes deeper
/// than its own depth in the scene, or than its body is thick under it; else empty. A wall that gives way is as thick
/// as it was: what counts is where its far side has come under these loads.
std::string depth_warning(const Model& model, const Probe& probe, double depth, const Loads& loads);

/// Those of all probes, pressed to one depth.
std::vector<std::string> depth_warnings(const Model& model, double depth, const Loads& loads);

}  // namespace palpate::sim
