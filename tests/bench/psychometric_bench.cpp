// 10 000 bootstrap refits of a psychometric function with six levels, threshold, slope and lapse rate free.
// psychometric.R times the same by R's optim; the target psychometric_speed runs both and prints the
// ratio.
#include <benchmark/benchmark.h>

#include <vector>

#include "analysis/psychometric/bootstrap.hpp"

namespace palpate::analysis {
namespace {

void refits(benchmark::State& state, Shape shape) {
  const std::vector<Block> blocks{{1, 26, 50}, {3, 30, 50}, {5, 38, 50},
                                  {7, 46, 50}, {9, 50, 50}, {11, 49, 50}};
  const Design design = make_design(blocks, {.shape = shape});
  const Fitter fitter(design);
  const std::vector<double> psi = fitted_psi(design, fitter.fit(correct_in(design, blocks)));
  constexpr long kReplicates = 10'000;
  std::uint64_t seed = 1;
  for (auto _ : state) {
    const auto replicates = bootstrap_replicates(fitter, psi, seed++, {0, kReplicates});
    benchmark::DoNotOptimize(replicates.data());
  }
}
BENCHMARK_CAPTURE(refits, logistic, Shape::Logistic)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(refits, gaussian, Shape::Gaussian)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(refits, weibull, Shape::Weibull)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(refits, gumbel_left, Shape::GumbelLeft)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(refits, gumbel_right, Shape::GumbelRight)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace palpate::analysis

BENCHMARK_MAIN();
