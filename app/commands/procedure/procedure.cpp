#include "app/commands/procedure/procedure.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "app/command_line/output.hpp"
#include "app/command_line/plot.hpp"
#include "app/commands/procedure/replayed_output.hpp"

namespace palpate::app {
namespace {

struct ProcedureOptions {
  std::string file, answers, format, plot;
};

void run_procedure(const ProcedureOptions& options) {
  if (!options.plot.empty()) check_plot_file(options.plot);
  const trials::LoadedProcedure loaded = trials::load_adaptive(options.file);
  const ReplayedRun run =
      replay_answers(loaded, options.answers.empty() ? std::vector<bool>() : parse_answers(options.answers));
  if (!options.plot.empty()) draw_plot(run_plot(loaded, run), options.plot);
  if (options.format == "json") {
    print_json(run_as_json(loaded, run));
  } else {
    fmt::print("{}", options.format == "csv" ? run_as_csv(loaded, run) : run_as_text(loaded, run));
  }
}

void add_procedure(CLI::App& command) {
  auto options = std::make_shared<ProcedureOptions>();
  command.add_option("FILE", options->file, "TOML file with a [procedure] table")->required();
  command.add_option(
      "--answers", options->answers,
      "Answers in order: 1 correct, 0 wrong, as in 1,0,1; without them the first level is told");
  command.add_option("--format", options->format, "What to print the result as")
      ->check(CLI::IsMember({"text", "json", "csv"}))
      ->default_val("text");
  command.add_option("--plot", options->plot, "Draw the levels over the trials: .svg or .png");
  std::string kinds;
  for (const trials::AdaptiveProcedure* procedure : trials::adaptive_procedures())
    kinds += fmt::format("  {:<10} {}\n", procedure->name, procedure->meaning);
  command.footer("Kinds (docs/procedures.md has their keys):\n" + kinds +
                 "\nExample:\n  palpate procedure staircase.toml --answers 1,1,0,1 --plot staircase.svg\n");
  command.callback([options] { run_procedure(*options); });
}

}  // namespace

const Command procedure_command{.name = "procedure",
                                .summary = "Which levels an adaptive procedure asks for, given the answers",
                                .heading = "Run a study",
                                .add = add_procedure};

}  // namespace palpate::app
