#include "app/commands/simulate/simulate.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/command_line/output.hpp"
#include "app/study/simulation.hpp"
#include "base/text/counted.hpp"

namespace palpate::app {
namespace {

struct SimulateOptions {
  std::string protocol, study, observer, format;
  int examinees = 0;
  trials::Seed seed{};
};

void run_simulate(const SimulateOptions& options) {
  const std::filesystem::path observer =
      options.observer.empty() ? default_observer() : std::filesystem::path(options.observer);
  const SimulationResult result =
      run_simulation(options.protocol, options.study, options.examinees, observer, options.seed);
  const trials::SimulationReport& report = result.report;
  if (options.format == "json") {
    const nlohmann::ordered_json json = {{"study", options.study},
                                         {"examinees_finished_before", report.finished_before},
                                         {"examinees_resumed", report.resumed},
                                         {"examinees_added", report.added},
                                         {"answers", report.answers},
                                         {"receipt", trials::to_string(result.receipt)}};
    print_json(json);
    return;
  }
  fmt::print("{}: {} added, {} resumed, {} had finished before; {} given\n", options.study,
             base::counted(report.added, "simulated examinee", "simulated examinees"), report.resumed,
             report.finished_before, base::counted(report.answers, "answer", "answers"));
  fmt::print("receipt {}\n", trials::to_string(result.receipt));
}

void add_simulate(CLI::App& command) {
  auto options = std::make_shared<SimulateOptions>();
  command.add_option("protocol", options->protocol, "Protocol (TOML)")->required();
  command.add_option("--study", options->study, "Study file; made where there is none")->required();
  command.add_option("--examinees", options->examinees, "How many the study holds in the end")
      ->required()
      ->check(CLI::Range(1, 100000));
  command.add_option("--observer", options->observer,
                     "What they are like (TOML); else protocols/observers/default.toml");
  add_seed(command, "Makes orders and answers repeatable; else the system's entropy",
           [options](std::uint64_t seed) { options->seed = seed; });
  add_format(command, options->format);
  command.footer(
      "Example:\n  palpate simulate protocols/kuroda2003.toml --study simulated.db --examinees 15 --seed 1\n"
      "Cut off by Ctrl-C or a power cut, the same command goes on with the first unanswered question.");
  command.callback([options] { run_simulate(*options); });
}

}  // namespace

const Command simulate_command{
    .name = "simulate",
    .summary = "Runs a study with simulated examinees, until the file holds as many as asked for",
    .heading = "Run a study",
    .add = add_simulate};

}  // namespace palpate::app
