#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/commands/commands.hpp"
#include "sim/io/atomic_file.hpp"
#include "trials/table.hpp"

namespace palpate::app {
namespace {

using nlohmann::ordered_json;

struct Options {
  std::string study, as, out;
};

struct NamedText {
  std::filesystem::path file;
  std::string text;
};

ordered_json as_json(const trials::Value& value) {
  return std::visit(
      [](const auto& held) -> ordered_json {
        if constexpr (std::is_same_v<std::decay_t<decltype(held)>, std::monostate>)
          return nullptr;
        else
          return held;
      },
      value);
}

/// Rows as objects, with the codebook beside them.
ordered_json as_json(const trials::Table& table) {
  ordered_json columns, rows = ordered_json::array();
  for (const trials::Column& column : table.columns) columns[column.name] = column.description;
  for (const auto& row : table.rows) {
    ordered_json object;
    for (std::size_t i = 0; i < row.size(); ++i) object[table.columns[i].name] = as_json(row[i]);
    rows.push_back(std::move(object));
  }
  return {{"columns", columns}, {"rows", rows}};
}

std::vector<NamedText> write_csv(const std::vector<trials::Table>& tables) {
  std::vector<NamedText> files;
  for (const trials::Table& table : tables) files.push_back({table.name + ".csv", trials::to_csv(table)});
  return files;
}

std::vector<NamedText> write_json(const trials::StudyRow& study, const std::vector<trials::Table>& tables) {
  ordered_json json = {{"study", study.uuid},
                       {"created_utc", study.created_utc},
                       {"protocol", study.protocol_name},
                       {"protocol_sha256", study.protocol_sha256},
                       {"software_version", study.software_version}};
  for (const trials::Table& table : tables) json[table.name] = as_json(table);
  return {{"study.json", json.dump(1) + "\n"}};
}

void run(const Options& options) {
  if (options.as != "csv" && options.as != "json")
    throw std::invalid_argument(
        fmt::format("--as: {} is not in this version; accepted: csv, json", options.as));
  const trials::StudyFile study = trials::read_study(options.study);
  const std::vector tables{trials::trial_table(study), trials::interval_table(study),
                           trials::exposure_table(study)};
  const auto files = options.as == "csv" ? write_csv(tables) : write_json(study.study(), tables);

  const std::filesystem::path folder = options.out;
  for (const NamedText& file : files)
    if (std::filesystem::exists(folder / file.file))
      throw std::invalid_argument(
          fmt::format("{}: is there already and is not overwritten; accepted: another folder",
                      (folder / file.file).string()));
  std::filesystem::create_directories(folder);
  for (const NamedText& file : files) {
    sim::write_atomically(folder / file.file, file.text);
    fmt::print("{}\n", (folder / file.file).string());
  }
}

}  // namespace

void add_export(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("export", "Writes the trial log for other tools");
  command->add_option("study", options->study, "Study file")->required();
  command->add_option("--as", options->as, "Format")
      ->required()
      ->check(CLI::IsMember({"csv", "json", "psych-ds", "bids"}));
  command->add_option("--out", options->out, "Folder for the files; nothing in it is overwritten")
      ->required();
  command->footer(
      "Example:\n  palpate export study.db --as csv --out exported\n"
      "trials: one row an answer; intervals: what was felt before it; exposures: what was shown but did not "
      "count.");
  command->callback([options] { run(*options); });
}

}  // namespace palpate::app
