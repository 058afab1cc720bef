#include "app/commands/stats/stats.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/description/statistic.hpp"
#include "analysis/statistics/psychometric/merge_bootstrap.hpp"
#include "analysis/statistics/statistics.hpp"
#include "app/command_line/bounded_json.hpp"
#include "app/command_line/output.hpp"
#include "app/commands/stats/read_csv.hpp"
#include "app/commands/stats/statistic_help.hpp"
#include "app/commands/stats/stats_batch.hpp"
#include "app/study/power_simulation.hpp"
#include "base/files/read_file.hpp"
#include "base/text/json_words.hpp"

namespace palpate::app {
namespace {

using analysis::Data;
using analysis::Input;
using analysis::Statistic;

// What stands behind the options of one statistic: texts, which read_arguments() reads.
struct Asked {
  std::map<std::string, std::string> texts;
  std::map<std::string, bool> switches;
  std::string file;
  std::string format;
  bool header = false, no_header = false;
};

analysis::DataTable table_of(const Asked& asked) {
  if (asked.file.empty()) return {};
  const FirstLine first = asked.header      ? FirstLine::Names
                          : asked.no_header ? FirstLine::Data
                                            : FirstLine::Unsaid;
  analysis::DataTable table = read_csv(asked.file, first);
  tell_notes(table);
  return table;
}

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

void run_stats(const Statistic& statistic, const CLI::App& command, const Asked& asked) {
  nlohmann::json values = nlohmann::json::object();
  for (const auto& [name, text] : asked.texts) {
    if (command.count("--" + name) > 0) values[name] = text;
  }
  for (const auto& [name, on] : asked.switches) values[name] = on;
  const analysis::Outcome outcome =
      statistic.run(analysis::read_arguments(statistic, values, table_of(asked)));
  if (asked.format == "json") {
    print_json(outcome.json);
  } else {
    fmt::print("{}", outcome.text);
  }
}

void add_statistic(CLI::App& stats, const Statistic& statistic) {
  CLI::App* command = stats.add_subcommand(statistic.name, summary_of(statistic));
  command->footer(teaching_of(statistic));
  const auto asked = std::make_shared<Asked>();
  if (statistic.data.shape != Data::Shape::None) {
    CLI::Option* file = command->add_option("FILE", asked->file, "CSV file: " + statistic.data.meaning);
    if (!statistic.data.optional) file->required();
    CLI::Option* header = command->add_flag("--header", asked->header,
                                            "The file's first line names the columns, also as numbers");
    command->add_flag("--no-header", asked->no_header, "The file's first line is data")->excludes(header);
  }
  for (const Input& input : statistic.inputs) add_input(*command, *asked, input);
  add_format(*command, asked->format);
  command->callback([&statistic, command, asked] { run_stats(statistic, *command, *asked); });
}

void add_list(CLI::App& stats) {
  CLI::App* command = stats.add_subcommand("list", "Every statistic with its inputs and outputs");
  command->footer("Example: the page that documents them\n  palpate stats list --format markdown\n");
  const auto format = std::make_shared<std::string>();
  command->add_option("--format", *format, "What to print")
      ->check(CLI::IsMember({"text", "json", "markdown"}))
      ->default_val("text");
  command->callback([format] {
    if (*format == "json") {
      print_json(statistics_as_json());
    } else {
      fmt::print("{}", *format == "markdown" ? statistics_as_markdown() : statistics_as_text());
    }
  });
}

void add_batch(CLI::App& stats) {
  CLI::App* command = stats.add_subcommand("batch", "Many statistics: JSON lines in, JSON lines out");
  command->footer(
      "Each line is an object: the statistic's name, its inputs by name, and its data as arrays or a CSV "
      "file.\n"
      "Any value but data may stand in an array of one, as R writes it; \"header\": true or false says what "
      "the\n"
      "first line of the file is.\n"
      "A line that cannot be answered gives a line with \"error\"; the others are answered all the same, and "
      "the\n"
      "exit code is 1. \"id\" is handed through.\n\n"
      "Example:\n"
      "  echo '{\"procedure\": \"binomial\", \"correct\": 37, \"trials\": 60}' | palpate stats batch\n");
  const auto file = std::make_shared<std::string>("-");
  command->add_option("FILE", *file, "JSON lines; - for standard input")->capture_default_str();
  command->callback([file] { run_batch(*file); });
}

nlohmann::ordered_json read_part(const std::string& file) {
  const std::string text = base::read_file(file, "what --shard K/N --format json printed");
  try {
    auto part = parse_bounded_json(text);
    if (part.is_object()) return part;
  } catch (const nlohmann::json::parse_error&) {
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", file, error.what()));
  }
  throw std::invalid_argument(file + ": no JSON object; accepted: what --shard K/N --format json printed");
}

bool is_power(const nlohmann::ordered_json& part) {
  return part.contains("kind") && part["kind"] == "power simulation";
}

// Reads all that is needed of a part before any are joined: what is wrong is said with the file's name.
nlohmann::ordered_json checked_part(const std::string& file) {
  nlohmann::ordered_json part = read_part(file);
  const auto refuse = [&file](const std::string& what) {
    throw std::invalid_argument(
        fmt::format("{}: {}; accepted: what --shard K/N --format json printed", file, what));
  };
  try {
    if (is_power(part)) {
      check_power_part(part);
    } else {
      analysis::check_bootstrap_part(part);
    }
  } catch (const nlohmann::json::exception& error) {
    refuse(base::json_words(error.what()));
  } catch (const std::invalid_argument& error) {
    refuse(error.what());
  }
  return part;
}

void merge(const std::vector<std::string>& files, const std::string& format) {
  std::vector<nlohmann::ordered_json> parts;
  parts.reserve(files.size());
  for (const std::string& file : files) parts.push_back(checked_part(file));
  if (std::ranges::any_of(parts, is_power) && !std::ranges::all_of(parts, is_power))
    throw std::invalid_argument(
        "parts of a power simulation and others; accepted: all parts of one computation");
  analysis::Outcome whole;
  if (is_power(parts.front())) {
    whole.json = merge_power(parts);
    whole.text = power_in_words(whole.json);
  } else {
    whole = analysis::merge_bootstrap(parts);
  }
  if (format == "json") {
    print_json(whole.json);
  } else {
    fmt::print("{}", whole.text);
  }
}

void add_merge_of_parts(CLI::App& stats) {
  CLI::App* command = stats.add_subcommand("merge", "Joins the parts that --shard K/N computed");
  command->footer(
      "The result has the same bits as one run.\n\n"
      "Example:\n"
      "  palpate plan protocols/kuroda2003.toml --studies 100 --shard 1/2 --format json > part1.json\n"
      "  palpate plan protocols/kuroda2003.toml --studies 100 --shard 2/2 --format json > part2.json\n"
      "  palpate stats merge part1.json part2.json\n");
  const auto files = std::make_shared<std::vector<std::string>>();
  const auto format = std::make_shared<std::string>();
  command->add_option("FILES", *files, "What each part printed with --format json")->required();
  add_format(*command, *format);
  command->callback([files, format] { merge(*files, *format); });
}

void add_stats(CLI::App& command) {
  command.footer(
      "Each statistic teaches when it applies: palpate stats binomial --help\n\n"
      "Example:\n"
      "  palpate stats binomial --correct 41 --trials 60 --chance 1/2 --side greater\n");
  command.require_subcommand(1);
  for (const Statistic& statistic : analysis::statistics()) add_statistic(command, statistic);
  add_batch(command);
  add_list(command);
  add_merge_of_parts(command);
}

}  // namespace

const Command stats_command{.name = "stats",
                            .summary = "One statistic on numbers or a CSV file",
                            .heading = "Statistics",
                            .add = add_stats};

}  // namespace palpate::app
