#include "app/commands/plan/plan.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "app/command_line/output.hpp"
#include "app/study/freeze_plan.hpp"
#include "app/study/power_simulation.hpp"
#include "app/study/simulation.hpp"
#include "app/study/study_plan.hpp"

namespace palpate::app {
namespace {

struct PlanOptions {
  std::string protocol, freeze, format;
  double overdispersion = 0.0;
  long studies = 0;
  std::uint64_t seed = 1;
  std::string observer, shard = "1/1";
};

void play_studies(const PlanOptions& options, const trials::Protocol& protocol) {
  PowerSimulation simulation{
      .studies = options.studies, .seed = options.seed, .observer = default_observer()};
  if (!options.observer.empty()) simulation.observer = options.observer;
  read_shard(options.shard, simulation);
  const nlohmann::ordered_json result = simulate_power(protocol, simulation);
  if (options.format == "json") {
    print_json(result);
  } else {
    fmt::print("{}", power_in_words(result));
  }
}

void run_plan(const PlanOptions& options) {
  const trials::Protocol protocol = trials::load_protocol(options.protocol);
  if (options.studies > 0) return play_studies(options, protocol);
  const StudyPlan plan = study_plan(protocol, options.overdispersion);
  const std::string frozen = options.freeze.empty() ? "" : freeze_plan(protocol, options.freeze);
  if (options.format == "json") {
    nlohmann::ordered_json json = to_json(plan);
    if (!frozen.empty()) json["frozen"] = {{"study", options.freeze}, {"sha256", frozen}};
    print_json(json);
    return;
  }
  fmt::print("{}", in_words(plan));
  if (!frozen.empty()) fmt::print("\nThe plan is frozen in {}, SHA-256 {}\n", options.freeze, frozen);
}

void add_plan(CLI::App& command) {
  const auto options = std::make_shared<PlanOptions>();
  command.add_option("PROTOCOL", options->protocol, "Protocol file")->required();
  command
      .add_option("--overdispersion", options->overdispersion,
                  "How unlike examinees are, 0 (all alike) to 1: gamma of a beta-binomial distribution")
      ->capture_default_str();
  command.add_option(
      "--freeze", options->freeze,
      "Write the analysis plan into this study file, before the first answer; the report then says "
      "what deviates from it");
  command
      .add_option("--studies", options->studies,
                  "Instead: power by playing so many whole studies with simulated observers")
      ->check(CLI::Range(1L, 1'000'000L))
      ->excludes("--freeze");
  command.add_option("--observer", options->observer, "What they are like (default: observers/default.toml)")
      ->needs("--studies");
  add_seed(command, "Of the simulated studies", [options](std::uint64_t seed) { options->seed = seed; })
      ->needs("--studies")
      ->default_str(std::to_string(options->seed));
  command
      .add_option("--shard", options->shard,
                  "Play only part K of N of the studies, as K/N; palpate stats merge joins the parts")
      ->needs("--studies");
  add_format(command, options->format);
  command.footer(
      "Power is computed for cells of up to 20000 trials, 500 with balanced orders; --studies plays any.\n\n"
      "Examples:\n"
      "  palpate plan protocols/kuroda2003.toml --overdispersion 0.1\n"
      "  palpate plan protocols/kuroda2003.toml --freeze study.db\n"
      "  palpate plan protocols/kuroda2003.toml --studies 100 --shard 1/4 --format json > part1.json\n");
  command.callback([options] { run_plan(*options); });
}

}  // namespace

const Command plan_command{.name = "plan",
                           .summary = "Critical numbers, power and sample size of a protocol",
                           .heading = "Run a study",
                           .add = add_plan};

}  // namespace palpate::app
