#include "sim/cost/tolerance_cost.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "sim/cost/press_poses.hpp"

namespace palpate::sim {
namespace {

/// One tolerance's simulation, and what its cycles took and gave.
struct Run {
  Run(const Model& scene, double tolerance) : model(scene) {
    model.contact_tolerance = tolerance;
    simulation = std::make_unique<Simulation>(model);
  }

  Model model;
  std::unique_ptr<Simulation> simulation{};
  std::vector<double> times{}, bounds{};  // [us], [-]
  int ended_early = 0;
};

/// The bound as part of the largest force on a probe; 0 where nothing pushes.
double relative_bound(const CycleResult& result) {
  double force = 0.0;
  for (const Vec3& on_probe : result.probe_forces) force = std::max(force, on_probe.norm());
  return force > 0.0 ? result.solve.force_error_bound / force : 0.0;
}

void press_to_and_fro(const std::vector<PressPose>& poses, Run& run, bool counted) {
  const int there_and_back = std::max(1, 2 * static_cast<int>(poses.size()) - 2);
  for (int i = 0; i < there_and_back; ++i) {
    const auto start = CycleClock::now();
    const CycleResult result = run.simulation->step(poses[to_and_fro(i, poses.size())].probes, kCyclePeriod);
    const double time = microseconds_since(start);
    if (!counted) continue;
    run.times.push_back(time);
    run.bounds.push_back(relative_bound(result));
    run.ended_early += result.solve.stop == Stop::WithinTolerance ? 1 : 0;
  }
}

/// Whether the law knows a bound of an error at any pose.
bool approximates(const std::vector<PressPose>& poses, Simulation& simulation) {
  return std::ranges::any_of(poses, [&](const PressPose& pose) {
    const double bound = simulation.step(pose.probes, kCyclePeriod).solve.force_error_bound;
    return bound > 0.0 && std::isfinite(bound);
  });
}

ToleranceCost cost_of(Run& run) {
  ToleranceCost cost{.tolerance = run.model.contact_tolerance,
                     .cycles = static_cast<int>(run.times.size()),
                     .ended_early = run.ended_early};
  cost.total = percentiles_of(std::move(run.times));
  std::ranges::sort(run.bounds);
  cost.median_bound = run.bounds[(run.bounds.size() - 1) / 2];
  cost.largest_bound = run.bounds.back();
  return cost;
}

}  // namespace

std::vector<ToleranceCost> measure_tolerances(const Model& model, const ContactLaw& law,
                                              const CycleSampling& sampling,
                                              std::span<const double> tolerances) {
  const Model alone_model = without_contact(model), whole = with_law(model, law);
  Simulation alone(alone_model);
  bool touching = false;
  const std::vector<PressPose> poses = poses_to_time(model, sampling, alone, touching);
  std::vector<std::unique_ptr<Run>> runs;  // a simulation keeps its model's address
  for (const double tolerance : tolerances) runs.push_back(std::make_unique<Run>(whole, tolerance));
  if (std::ranges::none_of(runs, [&](const auto& run) { return approximates(poses, *run->simulation); }))
    return {};
  const auto started = CycleClock::now();
  for (int turn = 0;; ++turn) {
    for (const auto& run : runs) press_to_and_fro(poses, *run, turn > 0);
    const bool enough = std::ssize(runs.front()->times) >= sampling.most_cycles ||
                        microseconds_since(started) > 1e6 * sampling.most_seconds;
    if (turn > 0 && enough) break;
  }
  std::vector<ToleranceCost> costs;
  costs.reserve(runs.size());
  for (const auto& run : runs) costs.push_back(cost_of(*run));
  return costs;
}

}  // namespace palpate::sim
