// The haptic cycle on Table 1's scene, bodies touching, and the limit that no cycle can beat: reading the
// compliance of the final contact set once. For percentiles see `palpate cost`.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/compile/compile.hpp"
#include "sim/compliance/cache.hpp"
#include "sim/contact/laws.hpp"
#include "sim/cost/cycle_cost.hpp"
#include "sim/cycle/press.hpp"
#include "sim/pairing/find_pairs.hpp"

namespace palpate::sim {
namespace {

constexpr double kDepth = 5e-3;         // [m], as the paper presses
constexpr double kFirstDepth = 2.5e-3;  // from here on the bodies touch; checked by compiled_scene()
constexpr int kPoses = 32;

std::vector<std::vector<ProbeDisplacement>> poses(const Model& model) {
  std::vector<std::vector<ProbeDisplacement>> all;
  for (int i = 0; i < kPoses; ++i)
    all.push_back(displaced_by(model, kFirstDepth + (kDepth - kFirstDepth) * i / (kPoses - 1)));
  for (int i = kPoses - 2; i > 0; --i) all.push_back(all[i]);  // and back
  return all;
}

const Model& table1() {
  static const Model model = [] {
    ComplianceCache cache("");
    return compile(
        load_scene(std::filesystem::path(PALPATE_SOURCE_DIR) / "data/scenes/rectal-palpation.toml"), cache);
  }();
  return model;
}

Model under(const char* law) {
  Model model = table1();
  model.law = &contact_law(law);
  return model;
}

int active_pairs(const CycleResult& result) {
  int active = 0;
  for (const PairSummary& pair : result.pairs) active += pair.active;
  return active;
}

/// The bodies moved by the probes alone.
FreeMotion free_motion_at(const Model& model, ProbeDisplacements probes) {
  const Model alone = without_contact(model);
  Simulation simulation(alone);
  simulation.step(probes, kCyclePeriod);
  return simulation.free_state().motion;
}

void whole_cycle(benchmark::State& state, const char* law) {
  const Model model = under(law);
  const auto all = poses(model);
  Simulation simulation(model);
  if (std::string_view(law) != "none" && active_pairs(simulation.step(all.front(), kCyclePeriod)) == 0) {
    state.SkipWithError("the bodies do not touch at the shallowest pose");
    return;
  }
  std::size_t at = 0;
  int active = 0;
  for (auto _ : state) {
    const CycleResult result = simulation.step(all[at], kCyclePeriod);
    benchmark::DoNotOptimize(result.probe_forces.data());
    active = std::max(active, active_pairs(result));
    at = at + 1 == all.size() ? 0 : at + 1;
  }
  state.counters["pairs"] = active;
}
BENCHMARK_CAPTURE(whole_cycle, none, "none")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(whole_cycle, sibille, "sibille")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(whole_cycle, kuroda, "kuroda")->Unit(benchmark::kMicrosecond);

void detection(benchmark::State& state) {
  const Model& model = table1();
  const FreeMotion motion = free_motion_at(model, displaced_by(model, kDepth));
  Placement placement = rest_placement(model);
  Pairs pairs;
  pairs.reserve(most_pairs(model));
  for (auto _ : state) {
    pairs.clear();
    place(model, motion, placement);
    find_pairs(model, motion, placement, pairs);
    benchmark::DoNotOptimize(pairs.data());
  }
  state.counters["pairs"] = static_cast<double>(pairs.size());
}
BENCHMARK(detection)->Unit(benchmark::kMicrosecond);

void limit_compliance_read_once(benchmark::State& state, const char* law) {
  const Model model = under(law);
  const std::vector<ProbeDisplacement> pose = displaced_by(model, kDepth);
  Simulation simulation(model);
  simulation.step(pose, kCyclePeriod);
  const ContactSet set = final_contact_set(model, pose, simulation.loads());
  for (auto _ : state) {
    benchmark::DoNotOptimize(read_once(set));
    benchmark::ClobberMemory();
  }
  state.counters["kB"] = 1e-3 * static_cast<double>(set.bytes);
}
BENCHMARK_CAPTURE(limit_compliance_read_once, sibille, "sibille")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(limit_compliance_read_once, kuroda, "kuroda")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace palpate::sim

BENCHMARK_MAIN();
