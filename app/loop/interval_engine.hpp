#pragma once

#include <cstdint>
#include <vector>

#include "app/loop/cycle_handover.hpp"
#include "app/loop/force_guard.hpp"
#include "devices/device/device.hpp"
#include "sim/cycle/simulation.hpp"
#include "trials/trace/trace.hpp"

namespace palpate::app {

constexpr double kCycleSeconds = 1e-3;  // the haptic loop runs at 1 kHz

/// The hand as it is known at a cycle.
struct HandInput {
  sim::Vec3 position = sim::Vec3::Zero();  // from where the probe rests [m]
  double age = 0.0;                        // since it was measured [s]
  bool known = false;                      // false until a first sample has come
};

/// What an interval looks like from outside, written by the haptic loop once a cycle. Depths are along the
/// press, negative above the skin.
struct IntervalState {
  std::uint32_t tick = 0;    // cycles of exploration so far
  double hand = 0.0;         // as followed [m]
  double depth = 0.0;        // of the probe, where the pointer is drawn [m]
  double force = 0.0;        // normal force as delivered [N]
  std::int32_t presses = 0;  // begun so far
  bool begun = false;        // the hand has been off the skin since the interval opened
  bool deep_enough = false;  // the hand has been as deep as the protocol asks for
  double time_left = 0.0;    // of the interval [s]; 0 without limit
  bool may_finish = false;   // the hand's depth and presses reach what the protocol asks for
  bool over = false;         // time or presses are used up
  Fault fault = Fault::None;
};

struct IntervalLimits {
  int least_presses = 1, most_presses = 1;
  double min_depth = 0.0;  // [m]
  double max_time = 0.0;   // [s]; 0: without limit, and no trace is kept
};

/// One interval, cycle by cycle: a pure function of the cycles so far and the hand's newest place, so that a
/// scripted path drives it without a clock. The hand moves the first probe. Allocates only when it is made.
/// Progress follows from the hand alone; of what is felt, only the pointer's place and the force tell.
class IntervalEngine {
 public:
  /// @param device  how the probe comes after the hand, and how much force the hand can get
  IntervalEngine(const sim::Model& model, const IntervalLimits& limits, const devices::Device& device);

  /// One wake-up of the loop: the force is computed once, and the probe moves on by one cycle. `elapsed`
  /// cycles have passed (more than one where cycles were missed): time counts them, and a force that falls
  /// falls by them, but nothing catches up, which would be felt as a kick.
  void tick(const HandInput& hand, int elapsed = 1);

  // Not while another thread ticks.
  const IntervalState& state() const { return state_; }
  const trials::Trace& trace() const { return trace_; }
  /// Of all cycles so far that gave a force.
  const trials::SolveRecord& solve_record() const { return solve_record_; }
  const sim::Model& model() const { return *model_; }
  /// Direction of the press, unit length.
  const sim::Vec3& press() const { return probe_.direction; }
  /// As delivered in the last cycle [N].
  const sim::Vec3& force_on_hand() const { return force_on_hand_; }

  /// Where another thread gets what the hand felt.
  CycleHandover& felt() { return felt_; }

 private:
  void advance(const HandInput& hand, int elapsed);
  double probe_force();
  void record(const sim::SolveReport& solve);
  void deliver();
  sim::Vec3 target(const HandInput& hand) const;
  void record();
  void judge_progress();

  const sim::Model* model_;
  IntervalLimits limits_;
  const devices::Device* device_;
  double largest_force_;  // that the hand may get [N]
  sim::Simulation simulation_;
  std::vector<sim::ProbeDisplacement> probes_;
  sim::Vec3 force_on_finger_ = sim::Vec3::Zero();
  sim::Vec3 sound_force_on_finger_ = sim::Vec3::Zero();  // the last one before a fault
  sim::Vec3 force_on_hand_ = sim::Vec3::Zero();
  devices::DrivenProbe probe_;
  ForceGuard guard_{};
  trials::PressCounter presses_{};
  double deepest_ = 0.0;  // place of the hand [m]
  trials::Trace trace_;
  trials::SolveRecord solve_record_{};
  IntervalState state_{};
  CycleHandover felt_;
};

}  // namespace palpate::app
