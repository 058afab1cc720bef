#pragma once

#include <cstdint>
#include <vector>

#include "app/loop/force_guard.hpp"
#include "app/loop/pseudo_haptic.hpp"
#include "sim/cycle/simulation.hpp"
#include "trials/trace/trace.hpp"

namespace palpate::app {

constexpr double kCycleSeconds = 1e-3;  // the haptic loop runs at 1 kHz

/// The hand as it is known at a cycle.
struct HandInput {
  double depth = 0.0;  // along the press, negative above the skin [m]
  double age = 0.0;    // since it was measured [s]
  bool known = false;  // false until a first sample has come
};

/// What an interval looks like from outside, written by the haptic loop once a cycle.
struct IntervalState {
  std::uint32_t tick = 0;    // cycles of exploration so far
  double hand = 0.0;         // as followed [m]
  double depth = 0.0;        // of the probe, where the pointer is drawn [m]
  double force = 0.0;        // normal force as delivered [N]
  std::int32_t presses = 0;  // begun so far
  bool begun = false;        // the hand has been off the skin since the interval opened
  bool may_finish = false;   // depth and presses reach what the protocol asks for
  bool over = false;         // time or presses are used up
  Fault fault = Fault::None;
};

struct IntervalLimits {
  int least_presses = 1, most_presses = 1;
  double min_depth = 0.0;  // [m]
  double max_time = 0.0;   // [s]; 0: without limit, and no trace is kept
};

/// One interval, cycle by cycle: a pure function of the cycles so far and the hand's newest place, so that a
/// scripted path drives it without a clock. Allocates only when it is made. Nothing that it reports depends
/// on anything but hand, depth and force: contact between organs is not looked at.
class IntervalEngine {
 public:
  IntervalEngine(const sim::Model& model, const IntervalLimits& limits,
                 const PseudoHapticCoupling& coupling = {});

  /// One wake-up of the loop: the force is computed once, and the probe moves on by one cycle. `elapsed`
  /// cycles have passed (more than one where cycles were missed): time counts them, and a force that falls
  /// falls by them, but nothing catches up, which would be felt as a kick.
  void tick(const HandInput& hand, int elapsed = 1);

  // Not while another thread ticks.
  const IntervalState& state() const { return state_; }
  const trials::Trace& trace() const { return trace_; }
  const sim::Model& model() const { return *model_; }

 private:
  double probe_force();
  double target(const HandInput& hand) const;
  void record(const sim::Vec3& force_on_finger);
  void judge_progress();

  const sim::Model* model_;
  IntervalLimits limits_;
  PseudoHapticCoupling coupling_;
  sim::Simulation simulation_;
  std::vector<sim::ProbeDisplacement> probes_;
  sim::Vec3 force_on_finger_ = sim::Vec3::Zero();
  sim::Vec3 sound_force_on_finger_ = sim::Vec3::Zero();  // the last one before a fault
  DrivenProbe probe_{};
  ForceGuard guard_{};
  trials::PressCounter presses_{};
  double deepest_ = 0.0;  // with force [m]
  trials::Trace trace_;
  IntervalState state_{};
};

}  // namespace palpate::app
