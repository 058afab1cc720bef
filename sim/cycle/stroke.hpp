#pragma once

#include <span>
#include <vector>

#include "sim/cycle/press.hpp"

namespace palpate::sim {

/// Where all probes are at a time.
struct StrokePose {
  double time = 0.0;                        // [s]
  std::vector<ProbeDisplacement> probes{};  // in the model's order
};

/// What a stroke has come to.
struct Stroke {
  std::vector<double> times{};  // of each step [s]
  std::vector<PressStep> steps{};
  Loads loads{};  // at the last step
};

/// Takes the probes through the poses, one cycle each, and nothing between them. Each cycle's dt is the time since
/// the pose before; the first one's, before which nothing was, is that of the haptic loop.
/// @param poses  at least one, their times ascending
Stroke stroke(const Model& model, std::span<const StrokePose> poses);

/// Throws std::runtime_error, with the time and the reason, where a step could not be solved.
void require_solved(const Stroke& stroke);

}  // namespace palpate::sim
