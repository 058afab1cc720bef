#pragma once

#include <vector>

#include "sim/cycle/simulation.hpp"

namespace palpate::sim {

/// One step of a press, as Fig. 8 of Kuroda et al. 2003 plots it, or of a stroke (stroke.hpp): one cycle.
struct PressStep {
  double depth = 0.0;                       // of the first probe along its direction [m]
  std::vector<ProbeDisplacement> probes{};  // where each is
  std::vector<Vec3> probe_forces{};         // on each finger [N]
  std::vector<Vec3> probe_torques{};        // on those that hold a region, about its centre [N m]
  std::vector<PairSummary> pairs{};         // in the model's order
  std::vector<double> penetration{};        // of each pair: deepest overlap that remains [m]
  SolveReport solve{};
  double cycle_us = 0.0;  // time that the cycle took here [microseconds]
};

struct Press {
  std::vector<PressStep> curve{};  // from the first step to the full depth
  Loads loads{};                   // at the last step
};

/// Presses every probe along its direction to `depth` in `steps` equal steps, one cycle each; the first step
/// is depth / steps. Probes move together.
Press press(const Model& model, double depth, int steps);

/// One cycle with the probes there, and what it has come to. @param dt  since the cycle before [s]
PressStep press_step(const Model& model, Simulation& simulation, ProbeDisplacements probes, double dt);

/// Throws std::runtime_error, with the depth and the reason, where a step could not be solved.
void require_solved(const Press& press);

/// A press: every probe displaced by `depth` along its direction.
std::vector<ProbeDisplacement> displaced_by(const Model& model, double depth);

/// Force that resists the press: what the finger feels against its direction, positive when pushed back [N].
double normal_force(const Probe& probe, const Vec3& force_on_finger);

}  // namespace palpate::sim
