#include <benchmark/benchmark.h>
#include <fmt/core.h>
#include <fmt/os.h>

#include <cmath>
#include <random>

#include "analysis/mixed/glmm.hpp"

// The mixed model of 30 examinees x 200 trials. glmm_bench.R fits the same answers with lme4 and prints the
// ratio: ninja glmm_speed. The answers are written to PALPATE_BENCH_FOLDER when the program starts.

using namespace palpate::analysis;

namespace {

/// At seven levels, as by constant stimuli, or everywhere between -2 and 2, as an adaptive procedure puts
/// them.
std::vector<LevelAnswers> simulated(bool seven_levels) {
  std::mt19937_64 random(30);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  std::vector<LevelAnswers> answers;
  for (int examinee = 1; examinee <= 30; ++examinee) {
    const double intercept = 0.5 * normal(random), slope = 1.2 + 0.3 * normal(random);
    for (int trial = 0; trial < 200; ++trial) {
      const double level = seven_levels ? 0.5 * (trial % 7 - 3) : 4 * uniform(random) - 2;
      const double p = std::erfc(-(intercept + slope * level) / std::sqrt(2.0)) / 2;
      answers.push_back({std::to_string(examinee), level, uniform(random) < p ? 1 : 0, 1});
    }
  }
  return answers;
}

const char* name_of_design(bool seven_levels) {
  return seven_levels ? "seven" : "anywhere";
}

void write(bool seven_levels) {
  auto file = fmt::output_file(fmt::format("{}/{}.csv", PALPATE_BENCH_FOLDER, name_of_design(seven_levels)));
  file.print("examinee,level,response\n");
  for (const LevelAnswers& row : simulated(seven_levels)) {
    file.print("{},{},{}\n", row.examinee, row.level, row.ones);
  }
}

// From the rows to estimates and standard errors, as glmer() goes.
void fit(benchmark::State& state, bool seven_levels, const GlmmOptions& options) {
  const std::vector<LevelAnswers> answers = simulated(seven_levels);
  GlmmFit result;
  for (auto _ : state) {
    result = fit_glmm(observations(answers), options);
    benchmark::DoNotOptimize(result);
  }
  if (!result.convergence.converged) state.SkipWithError(result.convergence.reason.c_str());
  state.counters["slope"] = result.fixed[1];
  state.counters["standard_error"] = std::sqrt(result.covariance(1, 1));
}

void add(bool seven_levels, const GlmmOptions& options) {
  const std::string name =
      fmt::format("{}/{}/{}/{}", name_of_design(seven_levels), name_of(options.link),
                  options.random == RandomEffects::Slope ? "slope" : "intercept", options.nodes);
  benchmark::RegisterBenchmark(name.c_str(), fit, seven_levels, options)->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int count, char** arguments) {
  benchmark::Initialize(&count, arguments);
  for (const bool seven_levels : {true, false}) {
    write(seven_levels);
    for (const Link link : {Link::Probit, Link::Logit}) {
      add(seven_levels, {.link = link, .random = RandomEffects::Intercept, .nodes = 1});
      add(seven_levels, {.link = link, .random = RandomEffects::Intercept, .nodes = 9});
      add(seven_levels, {.link = link, .random = RandomEffects::Slope, .nodes = 1});
    }
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
