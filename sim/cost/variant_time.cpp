#include "sim/cost/variant_time.hpp"

#include "sim/cost/press_poses.hpp"

namespace palpate::sim {
namespace {

constexpr int kPoses = 64, kLeastRounds = 3, kFirstCycles = 9;

double first_cycle(const Model& model, const PressPose& deepest) {
  std::vector<double> times;
  for (int i = 0; i < kFirstCycles; ++i) {
    Simulation fresh(model);
    const auto start = CycleClock::now();
    fresh.step(deepest.probes, kCyclePeriod);
    times.push_back(microseconds_since(start));
  }
  return percentiles_of(std::move(times)).median;
}

}  // namespace

VariantTime measure_time(const Model& model, double depth, double seconds) {
  const Model alone_model = without_contact(model);
  Simulation alone(alone_model), whole(model);
  bool touching = false;
  const std::vector<PressPose> poses =
      poses_to_time(model, {.depth = depth, .poses = kPoses}, alone, touching);
  const int there_and_back = std::max(1, 2 * static_cast<int>(poses.size()) - 2);
  VariantTime time{.first = first_cycle(model, poses.back())};
  std::vector<double> all;
  const auto started = CycleClock::now();
  for (int round = -1; round < kLeastRounds || microseconds_since(started) < 1e6 * seconds; ++round) {
    std::vector<double> times;
    for (int i = 0; i < there_and_back; ++i) {
      const auto start = CycleClock::now();
      whole.step(poses[to_and_fro(i, poses.size())].probes, kCyclePeriod);
      times.push_back(microseconds_since(start));
    }
    if (round < 0) continue;  // to warm up
    all.insert(all.end(), times.begin(), times.end());
    time.rounds.push_back(percentiles_of(std::move(times)).median);
  }
  time.warm = percentiles_of(std::move(all));
  return time;
}

}  // namespace palpate::sim
