#include "app/commands/stats/statistic_help.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "analysis/statistics/statistics.hpp"
#include "analysis/words/words.hpp"

namespace palpate::app {
namespace {

using analysis::Data;
using analysis::Input;
using analysis::InputColumn;
using analysis::Output;
using analysis::Statistic;
using nlohmann::ordered_json;

std::string_view name_of(Input::Kind kind) {
  switch (kind) {
    case Input::Kind::Count:
    case Input::Kind::Seed:
      return "whole number";
    case Input::Kind::Number:
      return "number";
    case Input::Kind::Fraction:
      return "fraction";
    case Input::Kind::Choice:
      return "choice";
    case Input::Kind::Counts:
      return "whole numbers";
    case Input::Kind::Numbers:
    case Input::Kind::PValues:
      return "numbers";
    case Input::Kind::Switch:
      return "switch";
    case Input::Kind::Text:
      break;
  }
  return "text";
}

// A value as it stands behind an option.
std::string option_text(const ordered_json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const ordered_json& item : value) text += (text.empty() ? "" : ",") + option_text(item);
  return text;
}

std::string example_options(const Statistic& statistic) {
  std::string options;
  for (const auto& item : statistic.example.items()) {
    if (item.key() == "data") continue;
    if (item.value() == true) {
      options += " --" + item.key();
    } else {
      options += fmt::format(" --{} {}", item.key(), option_text(item.value()));
    }
  }
  return options;
}

// The first rows of the example's data as the CSV file would hold them.
std::string example_file(const ordered_json& data, std::size_t rows) {
  std::string text = "  ";
  for (const auto& column : data.items()) text += (text.size() > 2 ? "," : "") + column.key();
  const std::size_t all = data.front().size();
  for (std::size_t row = 0; row < std::min(rows, all); ++row) {
    text += "\n  ";
    bool first = true;
    for (const auto& column : data.items()) {
      text += (first ? "" : ",") + option_text(column.value()[row]);
      first = false;
    }
  }
  if (all > rows) text += "\n  ...";
  return text + '\n';
}

std::string example_of(const Statistic& statistic) {
  const bool data = statistic.example.contains("data");
  std::string text = fmt::format("  palpate stats {}{}{}\n", statistic.name, data ? " data.csv" : "",
                                 example_options(statistic));
  if (data) text += "where data.csv begins\n" + example_file(statistic.example["data"], 4);
  return text;
}

std::string accepted(const Input& input) {
  if (!input.choices.empty()) return fmt::format("{}", fmt::join(input.choices, ", "));
  return std::string(name_of(input.kind));
}

std::string usual(const Input& input) {
  if (input.usual) return *input.usual;
  if (input.kind == Input::Kind::Switch) return "off";
  return input.optional ? "may be left out" : "needed";
}

std::string data_in_words(const Data& data) {
  std::string text = "CSV file: " + data.meaning + (data.optional ? " (may be left out)" : "") + ".\n";
  for (const InputColumn& column : data.columns) {
    text += fmt::format("  {:<14} {}{}\n", column.name, column.meaning,
                        column.optional ? " (may be left out)" : "");
  }
  return text;
}

std::string markdown_of(const Statistic& statistic) {
  std::string text = fmt::format("\n## {}\n\n**{}** ({})\n\n{}\n", statistic.name, statistic.question,
                                 statistic.title, analysis::wrapped(statistic.teaches, "", "", 119));
  if (statistic.data.shape != Data::Shape::None) {
    text += fmt::format("Data: {}{}.\n\n", statistic.data.meaning,
                        statistic.data.optional ? " (may be left out)" : "");
    if (!statistic.data.columns.empty()) text += "| column | meaning |\n|---|---|\n";
    for (const InputColumn& column : statistic.data.columns) {
      text += fmt::format("| `{}` | {}{} |\n", column.name, column.meaning,
                          column.optional ? " (may be left out)" : "");
    }
    if (!statistic.data.columns.empty()) text += '\n';
  }
  if (!statistic.inputs.empty()) text += "| input | accepted | usual | meaning |\n|---|---|---|---|\n";
  for (const Input& input : statistic.inputs) {
    text +=
        fmt::format("| `{}` | {} | {} | {} |\n", input.name, accepted(input), usual(input), input.meaning);
  }
  text += "\n| output | meaning |\n|---|---|\n";
  for (const Output& output : statistic.outputs) {
    text += fmt::format("| `{}` | {} |\n", output.name, output.meaning);
  }
  ordered_json line = {{"procedure", statistic.name}};
  line.update(statistic.example);
  return text + fmt::format("\n```\n{}\n```\n", line.dump());
}

ordered_json json_of(const Statistic& statistic) {
  ordered_json inputs = ordered_json::array(), columns = ordered_json::array(),
               outputs = ordered_json::array();
  for (const Input& input : statistic.inputs) {
    inputs.push_back({{"name", input.name},
                      {"accepted", accepted(input)},
                      {"usual", input.usual ? ordered_json(*input.usual) : ordered_json(nullptr)},
                      {"needed", usual(input) == "needed"},
                      {"meaning", input.meaning}});
  }
  for (const InputColumn& column : statistic.data.columns) {
    columns.push_back({{"name", column.name}, {"needed", !column.optional}, {"meaning", column.meaning}});
  }
  for (const Output& output : statistic.outputs) {
    outputs.push_back({{"name", output.name}, {"meaning", output.meaning}});
  }
  return {{"name", statistic.name},
          {"question", statistic.question},
          {"title", statistic.title},
          {"teaches", statistic.teaches},
          {"inputs", inputs},
          {"data", statistic.data.meaning},
          {"columns", columns},
          {"outputs", outputs},
          {"example", statistic.example}};
}

}  // namespace

std::string summary_of(const Statistic& statistic) {
  return statistic.question + " (" + statistic.title + ")";
}

std::string teaching_of(const Statistic& statistic) {
  std::string text = analysis::wrapped(statistic.teaches);
  if (statistic.data.shape != Data::Shape::None) text += '\n' + data_in_words(statistic.data);
  return text + "\nExample:\n" + example_of(statistic);
}

std::string statistics_as_text() {
  std::string text;
  for (const Statistic& statistic : analysis::statistics()) {
    text += fmt::format("{:<16} {}\n", statistic.name, summary_of(statistic));
  }
  return text + "\nWhat each takes and gives: palpate stats NAME --help, or docs/statistics.md\n";
}

std::string statistics_as_markdown() {
  std::string text =
      "# Statistics\n\n"
      "Made by `palpate stats list --format markdown`. Each statistic is had three ways with the same names: as\n"
      "`palpate stats NAME --input value [FILE.csv]`, as a line of JSON for `palpate stats batch` (the last block of\n"
      "each section), and, with `--format json`, as a result with the outputs listed. Every result also holds\n"
      "`procedure` and `method` (its name and source). What is infinite or undefined is null.\n";
  for (const Statistic& statistic : analysis::statistics()) text += markdown_of(statistic);
  return text;
}

ordered_json statistics_as_json() {
  ordered_json all = ordered_json::array();
  for (const Statistic& statistic : analysis::statistics()) all.push_back(json_of(statistic));
  return all;
}

}  // namespace palpate::app
