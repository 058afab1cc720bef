// One wake-up of the haptic loop on Table 1's scene, pressing and letting go: while nobody draws, while a
// picture asks for its loads as often as pictures are drawn (every 25th cycle), and in every cycle.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "app/loop/interval_engine.hpp"
#include "devices/devices.hpp"
#include "sim/compile/compile.hpp"
#include "sim/compliance/cache.hpp"
#include "sim/scene/scene.hpp"

namespace palpate::app {
namespace {

sim::Model table1(const std::string& law) {
  static sim::ComplianceCache cache("");
  const std::vector<sim::Override> overrides = {{"contact.model", "\"" + law + "\""}};
  return sim::compile(
      sim::load_scene(std::string(PALPATE_SOURCE_DIR) + "/data/scenes/rectal-palpation.toml", overrides),
      cache);
}

/// @param every  cycles from one question to the next; 0: none is asked
void tick(benchmark::State& state, const std::string& law, int every) {
  const sim::Model model = table1(law);
  const devices::Device& device = *devices::all().front();
  IntervalEngine engine(model, {}, device);  // without limit: no trace is kept
  const sim::Vec3 press = engine.press();
  int cycle = 0;
  for (auto _ : state) {
    if (every > 0 && cycle % every == 0) engine.felt().ask();
    const double depth = 5e-3 - 6e-3 * std::cos(2 * std::numbers::pi * cycle * kCycleSeconds);
    engine.tick({.position = depth * press, .known = true});
    benchmark::DoNotOptimize(engine.state().force);
    ++cycle;
  }
}

void register_ticks() {
  for (const std::string law : {"none", "sibille", "kuroda"})
    for (const int every : {0, 25, 1})
      benchmark::RegisterBenchmark(("tick/" + law + "/asked_every:" + std::to_string(every)).c_str(),
                                   [law, every](benchmark::State& state) { tick(state, law, every); })
          ->Iterations(20'000)  // twenty presses of a second
          ->Unit(benchmark::kMicrosecond);
}

}  // namespace
}  // namespace palpate::app

int main(int argc, char** argv) {
  palpate::app::register_ticks();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
