#include "trials/observer/observer.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace palpate::trials {
namespace {

constexpr double kNormalAt75 = 0.674489750196082;  // 75th percentile of the standard normal distribution
constexpr double kShortestWayIn = 0.2, kLongestWayIn = 0.9;  // [s] of the one second of an interval

/// The course from rest to rest with the least jerk, 0 to 1. Source: [Flash1985] eq. (A6).
double minimum_jerk(double tau) {
  tau = std::clamp(tau, 0.0, 1.0);
  return tau * tau * tau * (10 + tau * (-15 + 6 * tau));
}

/// A slow or fast wave of random phase, given by its root mean square.
struct Wave {
  double amplitude = 0.0, period = 1.0, phase = 0.0;
  double at(double time) const { return amplitude * std::sin(2 * std::numbers::pi * time / period + phase); }
};

Wave draw_wave(double rms, double period, Generator& generator) {
  return {.amplitude = rms * std::numbers::sqrt2,
          .period = period * (0.8 + 0.4 * generator.uniform()),
          .phase = 2 * std::numbers::pi * generator.uniform()};
}

double draw(const Variation& variation, Generator& generator) {
  return variation.mean + variation.between * generator.normal();
}

std::array<float, 3> single(const sim::Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

}  // namespace

Observer draw_observer(const ObserverParameters& p, Generator& generator) {
  Observer observer{.parameters = &p};
  // Nobody presses outwards, or tells apart what does not differ: a tenth of the mean is the least.
  observer.depth = std::max(draw(p.depth, generator), 0.1 * p.depth.mean);
  observer.duration = draw(p.duration, generator);
  observer.weber_fraction = std::max(draw(p.weber_fraction, generator), 0.1 * p.weber_fraction.mean);
  observer.interval_bias = draw(p.interval_bias, generator);
  return observer;
}

std::vector<sim::Vec3> plan_press(const Observer& observer, const sim::Vec3& direction,
                                  Generator& generator) {
  const ObserverParameters& p = *observer.parameters;
  const double depth = std::max(0.0, observer.depth + p.depth.within * generator.normal());
  const double duration =
      std::clamp(observer.duration + p.duration.within * generator.normal(), kShortestWayIn, kLongestWayIn);
  const Wave tremor = draw_wave(p.tremor, p.tremor_period, generator);
  const Wave drift_a = draw_wave(p.drift, p.drift_period, generator);
  const Wave drift_b = draw_wave(p.drift, p.drift_period, generator);
  const sim::Vec3 across_a = direction.unitOrthogonal(), across_b = direction.cross(across_a);

  std::vector<sim::Vec3> path;
  path.reserve(kObserverCycles);
  for (int i = 0; i < kObserverCycles; ++i) {
    const double time = i / kObserverRate, in = minimum_jerk(time / duration);
    path.push_back((depth + tremor.at(time)) * in * direction +
                   in * (drift_a.at(time) * across_a + drift_b.at(time) * across_b));
  }
  return path;
}

IntervalRecord drive(const sim::Model& model, sim::Simulation& simulation, const std::vector<sim::Vec3>& path,
                     const ForceOutput& output) {
  const sim::Vec3 direction = model.probes.front().direction;
  std::vector<sim::ProbeDisplacement> probes(model.probes.size());  // the other probes stay where they rest
  IntervalRecord record{.trace = Trace(path.size())};
  std::size_t clamped = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    probes.front().from_rest = path[i];
    const sim::CycleResult result = simulation.step(probes, 1 / kObserverRate);
    sim::Vec3 force = output.force_scale * result.probe_forces.front();
    const double magnitude = force.norm();
    if (magnitude > output.max_force) {
      force *= output.max_force / magnitude;
      ++clamped;
    }
    const auto depth = static_cast<float>(path[i].dot(direction));
    record.trace[i] = {.time = static_cast<float>(static_cast<double>(i) / kObserverRate),
                       .proposed_depth = depth,
                       .depth = depth,
                       .displacement = single(path[i]),
                       .force = single(force)};
  }
  record.clamped_fraction =
      path.empty() ? 0.0 : static_cast<double>(clamped) / static_cast<double>(path.size());
  return record;
}

std::optional<double> perceive(const Trace& felt, const Observer& observer, Generator& generator) {
  const ObserverParameters& p = *observer.parameters;
  double force_depth = 0.0, depth_depth = 0.0;
  for (const TraceSample& sample : felt) {
    const double force = std::hypot(sample.force[0], sample.force[1], sample.force[2]);
    if (!(force > 0.0)) continue;  // the finger is off the skin
    const double noisy_depth = sample.depth + p.position_noise * generator.normal();
    const double noisy_force = force + p.force_noise * generator.normal();
    force_depth += noisy_force * noisy_depth;
    depth_depth += noisy_depth * noisy_depth;
  }
  if (!(force_depth > 0.0)) return std::nullopt;
  // The difference of two intervals has sqrt(2) times this deviation; ln(1 + w) is then its 75th percentile.
  const double deviation = std::log1p(observer.weber_fraction) / (std::numbers::sqrt2 * kNormalAt75);
  return std::log(force_depth / depth_depth) + deviation * generator.normal();
}

double deviation_of_difference(const Observer& observer) {
  return std::log1p(observer.weber_fraction) / kNormalAt75;
}

}  // namespace palpate::trials
