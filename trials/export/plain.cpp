// CSV and JSON: the tables as they are, with their codebook beside them.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "base/files/new_folder.hpp"
#include "trials/export/datasets.hpp"
#include "trials/export/json_number.hpp"
#include "trials/export/words.hpp"
#include "trials/tables/delimited.hpp"

namespace palpate::trials {
namespace {

using nlohmann::ordered_json;
using Beside = base::NewFolder::Beside;

Value optional_number(const std::optional<double>& value) {
  return value ? Value(*value) : Value();
}

/// The codebook of all tables as a table of its own.
Table codebook_table(const std::vector<Table>& tables) {
  Table codebook{.name = "codebook"};
  for (const char* name : {"table", "column", "title", "description", "unit", "kind", "minimum", "maximum",
                           "levels", "pattern", "may_be_missing"})
    codebook.columns.push_back({.name = name});
  for (const Table& table : tables)
    for (const Column& column : table.columns) {
      std::vector<std::string> levels;
      for (const Level& level : column.levels)
        levels.push_back(fmt::format("{}: {}", level.value, level.meaning));
      codebook.rows.push_back({table.name, column.name, column.title, plain_text(column.description),
                               column.unit, std::string(to_string(column.kind)),
                               optional_number(column.least), optional_number(column.most),
                               plain_text(fmt::format("{}", fmt::join(levels, " | "))), column.pattern,
                               std::int64_t{column.may_be_missing ? 1 : 0}});
    }
  return codebook;
}

ordered_json as_json(const Value& value) {
  return std::visit(
      [](const auto& held) -> ordered_json {
        if constexpr (std::is_same_v<std::decay_t<decltype(held)>, std::monostate>)
          return nullptr;
        else
          return held;
      },
      value);
}

ordered_json as_json(const Column& column) {
  ordered_json object = {{"title", column.title},
                         {"description", column.description},
                         {"kind", to_string(column.kind)},
                         {"may_be_missing", column.may_be_missing}};
  if (!column.unit.empty()) object["unit"] = column.unit;
  if (column.least) object["minimum"] = json_number(*column.least);
  if (column.most) object["maximum"] = json_number(*column.most);
  if (!column.pattern.empty()) object["pattern"] = column.pattern;
  for (const Level& level : column.levels) object["levels"][level.value] = level.meaning;
  return object;
}

/// Rows as objects; `columns` holds the descriptions alone, `codebook` all that is known of a column.
ordered_json as_json(const Table& table) {
  ordered_json columns, codebook, rows = ordered_json::array();
  for (const Column& column : table.columns) {
    columns[column.name] = column.description;
    codebook[column.name] = as_json(column);
  }
  for (const auto& row : table.rows) {
    ordered_json object;
    for (std::size_t i = 0; i < row.size(); ++i) object[table.columns[i].name] = as_json(row[i]);
    rows.push_back(std::move(object));
  }
  return {{"columns", columns}, {"codebook", codebook}, {"rows", rows}};
}

}  // namespace

void export_csv(const StudyFile& study, const std::filesystem::path& folder) {
  std::vector<Table> tables = checked_tables(study, answered_trials(study), exposures(study));
  tables.push_back(codebook_table(tables));
  base::NewFolder files(folder, Beside::Others);
  std::vector<std::string> problems;
  for (const Table& table : tables) {
    const std::string text = to_csv(table), name = table.name + ".csv";
    read_strictly(text, ',', name, problems);
    files.add(name, text);
  }
  refuse_problems("the CSV files", problems);
  files.finish();
}

void export_json(const StudyFile& study, const std::filesystem::path& folder) {
  const StudyRow row = study.study();
  ordered_json object = {{"study", row.uuid},
                         {"created_utc", row.created_utc},
                         {"protocol", row.protocol_name},
                         {"protocol_sha256", row.protocol_sha256},
                         {"software_version", row.software_version},
                         {"description", describe_dataset(study)}};
  for (const Table& table : checked_tables(study, answered_trials(study), exposures(study)))
    object[table.name] = as_json(table);
  base::NewFolder files(folder, Beside::Others);
  files.add("study.json", object.dump(1) + "\n");
  files.finish();
}

}  // namespace palpate::trials
