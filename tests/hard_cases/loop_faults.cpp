// 42, 43, 44, 46, 47: what devices and machines do, and what the hand feels of it.
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/loop/force_guard.hpp"
#include "app/loop/interval_engine.hpp"
#include "app/loop/loop_clock.hpp"
#include "tests/hard_cases/runs.hpp"
#include "tests/hard_cases/scenes.hpp"

namespace palpate::hard_cases {
namespace {

constexpr double kLimit = 3.0;  // of the arm [N]

/// A device that pushes back: the probe is where the hand is.
const devices::Device kArm{.name = "arm",
                           .facts = {.gives_force = true, .continuous_force = kLimit},
                           .move = [](devices::DrivenProbe& probe, const Vec3& target, double, double step) {
                             devices::hold_probe(probe, target, step);
                           }};

const app::IntervalLimits kLong{.least_presses = 1, .most_presses = 100, .max_time = 30.0};

sim::Model pressed_model(Jitter& jitter) {
  return compiled(two_boxes(jitter), "exact");
}

/// An engine whose hand presses to `depth` and has come to rest there.
struct Pressing {
  Pressing(Jitter& jitter, double to) : model(pressed_model(jitter)), engine(model, kLong, kArm), depth(to) {
    tick(-1e-3);
    for (int cycle = 0; cycle < 200; ++cycle) tick(depth);
  }
  void tick(double at, double age = 0.0, bool known = true, int elapsed = 1) {
    engine.tick({.position = at * engine.press(), .age = age, .known = known}, elapsed);
  }
  double force() const { return engine.force_on_hand().norm(); }

  sim::Model model;
  app::IntervalEngine engine;
  double depth;
};

/// Cycles until no force is left, the hand told by `tick`; at most 1000. Notes where the force rises meanwhile.
template <class Tick>
double time_to_zero(const Pressing& press, Outcome& outcome, Tick tick) {
  double before = press.force();
  outcome.expect(before > 0.1, "nothing is felt to begin with");
  for (int cycle = 1; cycle <= 1000; ++cycle) {
    tick(cycle);
    outcome.expect(press.force() <= before + 1e-9, "the force rises");
    before = press.force();
    if (before == 0.0) return cycle;
  }
  return INFINITY;
}

}  // namespace

Outcome bad_device(Jitter& jitter) {
  Outcome outcome{.limit = 20.0};
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity(), jitter.of(1e30)}) {
    Pressing press(jitter, jitter.of(1e-3));
    const double depth = press.depth;
    const double cycles =
        time_to_zero(press, outcome, [&](int cycle) { press.tick(cycle == 1 ? bad : depth); });
    outcome.figure = std::max(outcome.figure, 1e3 * app::kCycleSeconds * cycles);
    for (int cycle = 0; cycle < 300; ++cycle) press.tick(cycle < 100 ? -1e-3 : depth);
    outcome.expect(press.force() == 0.0 && press.engine.state().fault == app::Fault::NotFinite,
                   "it does not latch");
    outcome.expect(std::isfinite(press.engine.state().depth), "the probe is nowhere");
  }
  return outcome;
}

Outcome gap_in_input(Jitter& jitter) {
  Outcome outcome{.limit = 1.0 + 1e-6};
  const app::GuardTimes times;
  app::ForceGuard guard;
  const double force = jitter.of(2.0);
  double before = app::guard_force(guard, times, true, 0.0, force, kLimit, app::kCycleSeconds);
  for (int cycle = 1; cycle <= 700; ++cycle) {  // 500 ms without input, then it is there again
    const double age = cycle <= 500 ? cycle * app::kCycleSeconds : 0.0;
    const double now = app::guard_force(guard, times, true, age, force, kLimit, app::kCycleSeconds);
    outcome.figure = std::max(outcome.figure, (now - before) / (force * app::kCycleSeconds / times.ramp_up));
    before = now;
    if (cycle == 500) outcome.expect(now == 0.0, "a force is left after 500 ms");
  }
  // And the whole engine: the probe does not jump, and no force is larger than the one that was held.
  Pressing press(jitter, jitter.of(1e-3));
  const double held = press.force();
  double depth = press.engine.state().depth;
  for (int cycle = 1; cycle <= 700; ++cycle) {
    press.tick(press.depth, cycle <= 500 ? cycle * app::kCycleSeconds : 0.0);
    outcome.expect(std::abs(press.engine.state().depth - depth) <=
                       devices::kLargestHandSpeed * app::kCycleSeconds * (1 + 1e-9),
                   "the probe jumps");
    outcome.expect(press.force() <= held * (1 + 1e-9), "a kick");
    depth = press.engine.state().depth;
  }
  outcome.expect(press.engine.state().fault == app::Fault::None, "a gap is a fault");
  return outcome;
}

Outcome overrun(Jitter& jitter) {
  Outcome outcome{.limit = 0.0};
  Pressing press(jitter, jitter.of(1e-3));
  const auto tick = press.engine.state().tick;
  const double held = press.force();
  press.tick(press.depth, 0.5, true, 20);  // 20 ms late, and what is known of the hand is old
  outcome.expect(press.engine.state().tick == tick + 20, "missed cycles are no time");
  outcome.figure = press.force() / held;
  Pressing late(jitter, 1e-3),
      punctual(jitter, 1e-3);  // a late cycle with fresh input catches up with nothing
  late.tick(3e-3, 0.0, true, 500);
  punctual.tick(3e-3);
  outcome.expect(late.force() <= punctual.force() * (1 + 1e-9), "a late cycle is felt as a kick");
  app::LoopClock clock;
  clock.reset();
  for (int cycle = 0; cycle < 100; ++cycle)
    clock.add(std::chrono::milliseconds(cycle % 10 == 0 ? 4 : 1), cycle % 10 == 0 ? 3 : 0);
  outcome.expect(clock.timing().missed_cycles == 30, "missed cycles are miscounted");
  return outcome;
}

Outcome device_lost(Jitter& jitter) {
  Outcome outcome{.limit = 20.0};
  Pressing press(jitter, jitter.of(1e-3));
  const double cycles = time_to_zero(
      press, outcome, [&](int cycle) { press.tick(press.depth, cycle * app::kCycleSeconds, false); });
  outcome.figure = 1e3 * app::kCycleSeconds * cycles;
  for (int cycle = 0; cycle < 100; ++cycle) press.tick(press.depth, 1.0, false);
  outcome.expect(press.force() == 0.0, "the motors are on");
  return outcome;
}

Outcome device_limit(Jitter& jitter) {
  SceneOf scene = two_boxes(jitter);
  for (BodyOf& body : scene.bodies) body.modulus = jitter.of(1e8);  // a hundred times as stiff
  const sim::Model model = compiled(scene, "exact");
  app::IntervalEngine engine(model, kLong, kArm);
  Outcome outcome{.limit = 1.0 + 1e-12};
  for (int cycle = 0; cycle < 300; ++cycle) {
    const double depth = cycle < 10 ? -1e-3 : jitter.of(1.5e-3);
    engine.tick({.position = depth * engine.press(), .known = true});
    outcome.figure = std::max(outcome.figure, engine.force_on_hand().norm() / kLimit);
  }
  const trials::TraceSample& last = engine.trace().back();
  const double recorded = std::hypot(last.force[0], last.force[1], last.force[2]);
  outcome.expect(std::abs(recorded - kLimit) <= 1e-6 * kLimit, "the trace does not hold what was delivered");
  return outcome;
}

}  // namespace palpate::hard_cases
