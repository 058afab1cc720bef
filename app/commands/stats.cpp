#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "analysis/procedures/procedure.hpp"
#include "app/commands/commands.hpp"
#include "app/output.hpp"
#include "app/procedure_help.hpp"
#include "app/read_csv.hpp"
#include "app/stats_batch.hpp"

namespace palpate::app {
namespace {

using analysis::Data;
using analysis::Input;
using analysis::Procedure;

// What stands behind the options of one procedure: texts, which read_arguments() reads.
struct Asked {
  std::map<std::string, std::string> texts;
  std::map<std::string, bool> switches;
  std::string file;
  std::string format;
};

void add_input(CLI::App& command, Asked& asked, const Input& input) {
  const std::string option = "--" + input.name;
  if (input.kind == Input::Kind::Switch) {
    command.add_flag(option, asked.switches[input.name], input.meaning);
    return;
  }
  CLI::Option* added = command.add_option(option, asked.texts[input.name], input.meaning);
  if (!input.choices.empty()) added->check(CLI::IsMember(input.choices));
  if (input.usual) {
    added->default_str(*input.usual);
  } else if (!input.optional) {
    added->required();
  }
}

void run(const Procedure& procedure, const CLI::App& command, const Asked& asked) {
  nlohmann::json values = nlohmann::json::object();
  for (const auto& [name, text] : asked.texts) {
    if (command.count("--" + name) > 0) values[name] = text;
  }
  for (const auto& [name, on] : asked.switches) values[name] = on;
  const analysis::Outcome outcome = procedure.run(analysis::read_arguments(
      procedure, values, asked.file.empty() ? analysis::DataTable{} : read_csv(asked.file)));
  if (asked.format == "json") {
    fmt::print("{}\n", outcome.json.dump(2));
  } else {
    fmt::print("{}", outcome.text);
  }
}

void add_procedure(CLI::App& stats, const Procedure& procedure) {
  CLI::App* command = stats.add_subcommand(procedure.name, summary_of(procedure));
  command->footer(teaching_of(procedure));
  const auto asked = std::make_shared<Asked>();
  if (procedure.data.shape != Data::Shape::None) {
    CLI::Option* file = command->add_option("FILE", asked->file, "CSV file: " + procedure.data.meaning);
    if (!procedure.data.optional) file->required();
  }
  for (const Input& input : procedure.inputs) add_input(*command, *asked, input);
  add_format(*command, asked->format);
  command->callback([&procedure, command, asked] { run(procedure, *command, *asked); });
}

void add_list(CLI::App& stats) {
  CLI::App* command = stats.add_subcommand("list", "Every procedure with its inputs and outputs");
  command->footer("Example: the page that documents them\n  palpate stats list --format markdown\n");
  const auto format = std::make_shared<std::string>();
  command->add_option("--format", *format, "What to print")
      ->check(CLI::IsMember({"text", "json", "markdown"}))
      ->default_val("text");
  command->callback([format] {
    if (*format == "json") {
      fmt::print("{}\n", procedures_as_json().dump(2));
    } else {
      fmt::print("{}", *format == "markdown" ? procedures_as_markdown() : procedures_as_text());
    }
  });
}

void add_batch(CLI::App& stats) {
  CLI::App* command = stats.add_subcommand("batch", "Many procedures: JSON lines in, JSON lines out");
  command->footer(
      "Each line is an object: the procedure's name, its inputs by name, and its data as arrays or a CSV "
      "file.\n"
      "A line that cannot be answered gives a line with \"error\"; the others are answered all the same, and "
      "the\n"
      "exit code is 1. \"id\" is handed through.\n\n"
      "Example:\n"
      "  echo '{\"procedure\": \"binomial\", \"correct\": 37, \"trials\": 60}' | palpate stats batch\n");
  const auto file = std::make_shared<std::string>("-");
  command->add_option("FILE", *file, "JSON lines; - for standard input")->capture_default_str();
  command->callback([file] { run_batch(*file); });
}

}  // namespace

void add_stats(CLI::App& app) {
  CLI::App* stats = app.add_subcommand("stats", "One statistical procedure on numbers or a CSV file");
  stats->footer(
      "Each procedure teaches when it applies: palpate stats binomial --help\n\n"
      "Example:\n"
      "  palpate stats binomial --correct 41 --trials 60 --chance 1/2 --side greater\n");
  stats->require_subcommand(1);
  for (const Procedure& procedure : analysis::procedures()) add_procedure(*stats, procedure);
  add_batch(*stats);
  add_list(*stats);
}

}  // namespace palpate::app
