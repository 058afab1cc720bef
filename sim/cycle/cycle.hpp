#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "sim/model/model.hpp"

namespace palpate::sim {

/// Where a probe is: its displacement from the place where it rests on the skin [m]. It presses while the
/// displacement along the probe's direction is positive; otherwise it has left the skin and feels nothing.
struct ProbePose {
  Vec3 displacement = Vec3::Zero();
};
using Pose = std::span<const ProbePose>;  // one a probe, in the model's order

/// What effects with history carry from cycle to cycle. No effect that this version simulates has any.
struct Memory {};

/// Nodal forces on the touchable nodes of each body [N], 3t entries each, the probes' included.
struct Loads {
  std::vector<Eigen::VectorXd> on_body{};
};

enum class Stop {
  Converged,
  IterationLimit,
  SingularMatrix,
  NotFinite
};                                      // NotFinite: a pose or a force is no number
std::string_view to_string(Stop stop);  // "converged", "singular matrix", ...
struct SolveReport {
  Stop stop = Stop::Converged;
  int iterations = 0;
  double residual = 0.0;  // largest error of what contact prescribed, relative to the largest such
                          // displacement; 0 without [-]
};

/// What happened between two bodies in one cycle.
struct PairSummary {
  int active = 0;                                            // colliding (node, polygon) pairs
  std::array<Vec3, 2> force_on{Vec3::Zero(), Vec3::Zero()};  // contact force on each body [N]
};

/// Force and contacts of one cycle. Spans point into the Scratch and hold until its next cycle.
struct CycleResult {
  std::span<const Vec3> probe_forces;  // what each finger feels: the body's reaction on it [N]
  std::span<const PairSummary> pairs;  // in the model's order
  SolveReport solve{};
};

/// Buffers and warm starts of the cycle, all allocated here and not in the cycle. One per thread.
class Scratch {
 public:
  explicit Scratch(const Model& model);
  ~Scratch();
  Scratch(Scratch&&) noexcept;
  Scratch& operator=(Scratch&&) noexcept;

  struct Buffers;
  Buffers& buffers() { return *buffers_; }
  const Loads& loads() const;                           // of the last cycle
  const Eigen::VectorXd& displacement(int body) const;  // of the touchable nodes after the last cycle, 3t [m]

 private:
  std::unique_ptr<Buffers> buffers_;
};

/// One update of the haptic loop: pose in, force out. Allocates nothing, locks nothing, and depends on the
/// pose alone: the same pose gives the same bits whatever cycles went before. A cycle that fails gives zero
/// force and says why (a pose that is not finite: Stop::NotFinite); nothing is ever guessed.
CycleResult cycle(const Model& model, const Memory& memory, Pose pose, Scratch& scratch);

/// Displacements of the drawn nodes of a body under loads [m], 3d entries, for frames. Outside the cycle.
Eigen::VectorXf deform(const Model& model, int body, const Loads& loads);

}  // namespace palpate::sim
