#pragma once

#include <memory>
#include <span>
#include <vector>

#include "sim/contact/prescribed/prescribed_solve.hpp"
#include "sim/model/contact_law.hpp"
#include "sim/model/free_state.hpp"
#include "sim/model/loads.hpp"
#include "sim/model/model.hpp"
#include "sim/model/solve_report.hpp"

namespace palpate::sim {

/// Time from cycle to cycle where nothing else is said [s]: the haptic loop runs at 1 kHz.
constexpr double kCyclePeriod = 1e-3;

/// Force and contacts of one cycle. Spans point into the simulation and hold until its next cycle.
struct CycleResult {
  std::span<const Vec3> probe_forces{};   // what each finger feels: the body's reaction on it [N]
  std::span<const Vec3> probe_torques{};  // likewise of those that hold a region, about its centre [N m]
  std::span<const PairSummary> pairs{};   // in the model's order; empty where no law has anything to do
  SolveReport solve{};
};

/// A compiled scene that runs: buffers and warm starts of the cycle, and what effects with history carry, all
/// allocated here and not in the cycle. What the scene does not call for takes none. One per thread.
class Simulation {
 public:
  /// @param model  outlives the simulation
  explicit Simulation(const Model& model);

  /// One update of the haptic loop: displacements in, force out. Allocates nothing, locks nothing, and
  /// depends on the displacements and the memory alone: without memory the same displacements give the same
  /// bits whatever cycles went before. A cycle that fails gives zero force and says why (a displacement that
  /// is not finite: Stop::NotFinite); nothing is ever guessed. @param dt  since the cycle before [s]
  CycleResult step(ProbeDisplacements probes, double dt);

  /// Forgets all history, as if no cycle had been.
  void reset();

  // Of the last cycle.
  const Loads& loads() const { return response_.loads; }
  /// Of the touchable nodes of a body under these loads, C f / E, 3t [m]. Allocates.
  Eigen::VectorXd displacement(int body) const;
  /// The displacements of all bodies, each taken to have moved. Allocates.
  FreeMotion motion() const;

  // What the contact law started from, and its own buffers (none: it has nothing to do), for measurements.
  const FreeState& free_state() const { return free_; }
  const LawScratch* law_scratch() const { return law_.get(); }

 private:
  SolveReport solve(ProbeDisplacements probes);
  void add_region_forces();
  void clear_response();

  const Model* model_;
  FreeState free_;
  std::vector<PrescribedSolve> free_solves_;  // of the probes alone, one a body
  std::unique_ptr<LawScratch> law_;
  std::vector<double> memory_;
  Response response_;
};

}  // namespace palpate::sim
