// The haptic cycle on Table 1's scene, bodies touching, and the limit that no cycle can beat: reading the
// compliance of the final contact set once. For percentiles see `palpate cost`.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/compliance/cache.hpp"
#include "sim/cost/cycle_cost.hpp"
#include "sim/cycle/press.hpp"
#include "sim/pairing/find_pairs.hpp"

namespace palpate::sim {
namespace {

constexpr double kDepth = 5e-3;         // [m], as the paper presses
constexpr double kFirstDepth = 2.5e-3;  // from here on the bodies touch; checked by compiled_scene()
constexpr int kPoses = 32;

std::vector<std::vector<ProbePose>> poses(const Model& model) {
  std::vector<std::vector<ProbePose>> all;
  for (int i = 0; i < kPoses; ++i)
    all.push_back(pose_at_depth(model, kFirstDepth + (kDepth - kFirstDepth) * i / (kPoses - 1)));
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

Model under(ContactModel law) {
  Model model = table1();
  model.law = law;
  return model;
}

int active_pairs(const CycleResult& result) {
  int active = 0;
  for (const PairSummary& pair : result.pairs) active += pair.active;
  return active;
}

/// Positions of the bodies moved by the probes alone.
FreeMotion free_motion_at(const Model& model, Pose pose) {
  Model alone = model;
  alone.law = ContactModel::None;
  Scratch scratch(alone);
  cycle(alone, {}, pose, scratch);
  FreeMotion motion = rest_motion(model);
  for (std::size_t i = 0; i < motion.size(); ++i) {
    motion[i].displacement = scratch.displacement(static_cast<int>(i));
    motion[i].moved = std::ranges::any_of(motion[i].displacement, [](double u) { return u != 0.0; });
  }
  return motion;
}

void whole_cycle(benchmark::State& state, ContactModel law) {
  const Model model = under(law);
  const auto all = poses(model);
  Scratch scratch(model);
  if (law != ContactModel::None && active_pairs(cycle(model, {}, all.front(), scratch)) == 0) {
    state.SkipWithError("the bodies do not touch at the shallowest pose");
    return;
  }
  std::size_t at = 0;
  int active = 0;
  for (auto _ : state) {
    const CycleResult result = cycle(model, {}, all[at], scratch);
    benchmark::DoNotOptimize(result.probe_forces.data());
    active = std::max(active, active_pairs(result));
    at = at + 1 == all.size() ? 0 : at + 1;
  }
  state.counters["pairs"] = active;
}
BENCHMARK_CAPTURE(whole_cycle, none, ContactModel::None)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(whole_cycle, sibille, ContactModel::Sibille)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(whole_cycle, kuroda, ContactModel::Kuroda)->Unit(benchmark::kMicrosecond);

void detection(benchmark::State& state) {
  const Model& model = table1();
  FreeMotion motion = free_motion_at(model, pose_at_depth(model, kDepth));
  Pairs pairs;
  pairs.reserve(most_pairs(model));
  for (auto _ : state) {
    pairs.clear();
    place(model, motion);
    find_pairs(model, motion, pairs);
    benchmark::DoNotOptimize(pairs.data());
  }
  state.counters["pairs"] = static_cast<double>(pairs.size());
}
BENCHMARK(detection)->Unit(benchmark::kMicrosecond);

void limit_compliance_read_once(benchmark::State& state, ContactModel law) {
  const Model model = under(law);
  const std::vector<ProbePose> pose = pose_at_depth(model, kDepth);
  Scratch scratch(model);
  cycle(model, {}, pose, scratch);
  const ContactSet set = final_contact_set(model, pose, scratch.loads());
  for (auto _ : state) {
    benchmark::DoNotOptimize(read_once(set));
    benchmark::ClobberMemory();
  }
  state.counters["kB"] = 1e-3 * static_cast<double>(set.bytes);
}
BENCHMARK_CAPTURE(limit_compliance_read_once, sibille, ContactModel::Sibille)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(limit_compliance_read_once, kuroda, ContactModel::Kuroda)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace palpate::sim

BENCHMARK_MAIN();
