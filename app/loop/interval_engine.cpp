#include "app/loop/interval_engine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/cycle/press.hpp"

namespace palpate::app {
namespace {

constexpr double kLifted = -1e-3;      // where the hand is taken to be while it is not known [m]
constexpr double kFarthestHand = 1.0;  // a place beyond this is no measurement [m]
constexpr double kLargestForce = 1e6;  // a mouse has no motor to protect: only what is no force at all [N]
constexpr GuardTimes kGuardTimes{.longest_gap = 0.2};

/// Room for every cycle of an interval, so that nothing is allocated while it runs.
std::size_t cycles_of(const IntervalLimits& limits) {
  return static_cast<std::size_t>(std::ceil(limits.max_time / kCycleSeconds)) + 1;
}

bool plausible(const sim::Vec3& position) {
  return position.allFinite() && position.lpNorm<Eigen::Infinity>() <= kFarthestHand;
}

}  // namespace

IntervalEngine::IntervalEngine(const sim::Model& model, const IntervalLimits& limits,
                               const devices::Device& device)
    : model_(&model),
      limits_(limits),
      device_(&device),
      largest_force_(device.facts.gives_force ? device.facts.continuous_force : kLargestForce),
      simulation_(model),
      probes_(model.probes.size()),
      probe_(devices::probe_at(model.probes.front().direction, kLifted, model.probes.front().depth)),
      felt_(model, probes_, simulation_.loads()) {
  if (limits_.max_time > 0) trace_.reserve(cycles_of(limits_));
  state_.hand = state_.depth = kLifted;
  state_.time_left = limits_.max_time;
}

double IntervalEngine::probe_force() {
  const sim::Probe& finger = model_->probes.front();
  probes_.front().from_rest = probe_.displacement;
  const sim::CycleResult result = simulation_.step(probes_, kCycleSeconds);
  if (!sim::solved(result.solve.stop)) return std::numeric_limits<double>::quiet_NaN();
  record(result.solve);
  force_on_finger_ = result.probe_forces.front();
  return sim::normal_force(finger, force_on_finger_);
}

void IntervalEngine::record(const sim::SolveReport& solve) {
  solve_record_.force_error_bound = std::max(solve_record_.force_error_bound, solve.force_error_bound);
  if (solve.stop == sim::Stop::WithinTolerance) ++solve_record_.cycles_within_tolerance;
  if (solve.stop == sim::Stop::CapReached) ++solve_record_.cycles_at_cap;
}

/// The hand is followed only while it is known, its input is fresh and nothing is wrong; else the finger is
/// lifted, at no more than the largest speed, so that neither loss nor return of the input is felt as a kick.
sim::Vec3 IntervalEngine::target(const HandInput& hand) const {
  const bool follow = hand.known && state_.begun && guard_.fault == Fault::None && plausible(hand.position) &&
                      hand.age <= kGuardTimes.longest_gap;
  return follow ? hand.position : sim::Vec3(kLifted * press());
}

void IntervalEngine::tick(const HandInput& hand, int elapsed) {
  if (!state_.over) advance(hand, elapsed);
  felt_.offer(probes_, simulation_.loads());
}

void IntervalEngine::advance(const HandInput& hand, int elapsed) {
  const bool sound_input = !hand.known || plausible(hand.position);
  if (hand.known && sound_input && hand.position.dot(press()) <= 0) state_.begun = true;
  const double force = probe_force();
  state_.force =
      guard_force(guard_, kGuardTimes, sound_input, hand.age, force, largest_force_, elapsed * kCycleSeconds);
  deliver();
  if (state_.begun) record();
  judge_progress();

  device_->move(probe_, target(hand), std::isfinite(force) ? force : 0.0, kCycleSeconds);
  if (state_.begun) state_.tick += static_cast<std::uint32_t>(elapsed);
  state_.hand = probe_.hand;
  state_.depth = probe_.depth;
  state_.fault = guard_.fault;
}

/// As the guard lets it through, and no larger than the device can hold.
void IntervalEngine::deliver() {
  if (guard_.fault == Fault::None) {
    sound_force_on_finger_ = force_on_finger_;
    const double size = sound_force_on_finger_.norm();
    if (size > largest_force_) sound_force_on_finger_ *= largest_force_ / size;
  }
  force_on_hand_ = guard_.gain * sound_force_on_finger_;
}

void IntervalEngine::record() {
  if (limits_.max_time <= 0 || trace_.size() == trace_.capacity()) return;
  const sim::Vec3 displacement = probes_.front().from_rest;
  trials::TraceSample sample;
  sample.time = static_cast<float>(state_.tick * kCycleSeconds);
  sample.proposed_depth = static_cast<float>(probe_.hand);
  sample.depth = static_cast<float>(probe_.depth);
  for (int axis = 0; axis < 3; ++axis) {
    sample.displacement[axis] = static_cast<float>(displacement[axis]);
    sample.force[axis] = static_cast<float>(force_on_hand_[axis]);
  }
  trace_.push_back(sample);
}

/// Counts with the sample just recorded, by the rule by which the session judges the trace.
void IntervalEngine::judge_progress() {
  if (!state_.begun) return;
  presses_.add(static_cast<float>(probe_.hand));
  deepest_ = std::max(deepest_, static_cast<double>(static_cast<float>(probe_.hand)));
  state_.presses = presses_.begun();
  state_.deep_enough = deepest_ >= limits_.min_depth;
  state_.may_finish = presses_.begun() >= limits_.least_presses && state_.deep_enough;
  state_.time_left = std::max(0.0, limits_.max_time - state_.tick * kCycleSeconds);
  if (limits_.max_time <= 0) return;
  const bool presses_used = presses_.begun() >= limits_.most_presses && !presses_.pressing();
  const bool time_used = (state_.tick + 1) * kCycleSeconds >= limits_.max_time;
  state_.over = presses_used || time_used;
}

}  // namespace palpate::app
