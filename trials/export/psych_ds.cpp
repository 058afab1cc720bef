// Psych-DS 1.5: one CSV file a table, every column described once in dataset_description.json.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "base/files/new_folder.hpp"
#include "trials/export/datasets.hpp"
#include "trials/export/json_number.hpp"
#include "trials/export/words.hpp"
#include "trials/tables/delimited.hpp"

namespace palpate::trials {
namespace {

using nlohmann::ordered_json;

ordered_json property_value(const Column& column) {
  ordered_json object = {
      {"@type", "PropertyValue"}, {"name", column.name}, {"description", column.description}};
  if (!column.levels.empty()) {
    std::string levels;
    for (const Level& level : column.levels)
      levels += fmt::format("{} {}: {}", levels.empty() ? "" : ";", level.value, level.meaning);
    if (column.kind == Kind::Text) object["description"] = fmt::format("{}.{}", column.description, levels);
  }
  if (!column.unit.empty()) object["unitText"] = column.unit;
  if (column.least) object["minValue"] = json_number(*column.least);
  if (column.most) object["maxValue"] = json_number(*column.most);
  if (const std::string pattern = pattern_of(column); !pattern.empty())
    object["valuePattern"] = fmt::format("^({})$", pattern);
  return object;
}

ordered_json description(const StudyFile& study, const ExportFacts& facts, const std::vector<Table>& tables) {
  const StudyRow row = study.study();
  ordered_json variables = ordered_json::array();
  std::set<std::string> described;
  for (const Table& table : tables)
    for (const Column& column : table.columns)
      if (described.insert(column.name).second) variables.push_back(property_value(column));
  ordered_json object = {{"@context", "https://schema.org"},
                         {"@type", "Dataset"},
                         {"name", "palpate study " + row.protocol_name},
                         {"description", describe_dataset(study)},
                         {"schemaVersion", "Psych-DS 1.5.0"},
                         {"identifier", row.uuid},
                         {"dateCreated", facts.exported_utc},
                         {"keywords", {"haptics", "psychophysics", "forced choice", row.protocol_name}},
                         {"measurementTechnique", describe_course(study.protocol())}};
  ordered_json authors = ordered_json::array();
  for (const std::string& author : facts.authors) authors.push_back({{"@type", "Person"}, {"name", author}});
  if (!authors.empty()) object["author"] = authors;
  object["variableMeasured"] = variables;
  return object;
}

std::string readme(const StudyFile& study, const std::vector<Table>& tables, const std::string& study_label) {
  std::string text = fmt::format(
      "# {}\n\n{}\n\n{}\nThe question: {}\n\n"
      "A Psych-DS data set, written by palpate. `materials/` holds the protocol and the scene as they were "
      "run. Missing values are `n/a`. Points in time are UTC.\n",
      study.study().protocol_name, describe_dataset(study), describe_course(study.protocol()),
      study.protocol().question);
  for (const Table& table : tables)
    text += fmt::format("\n## data/study-{}_description-{}_data.csv\n\n{}", study_label, table.name,
                        codebook_markdown(table));
  return text;
}

}  // namespace

void export_psych_ds(const StudyFile& study, const ExportFacts& facts, const std::filesystem::path& folder) {
  std::vector<Table> tables = checked_tables(study, answered_trials(study), exposures(study));
  if (tables.front().rows.empty())
    throw std::invalid_argument(
        "the study holds no answers yet; Psych-DS wants at least one data file with rows");
  std::erase_if(tables, [](const Table& table) { return table.rows.empty(); });
  const std::string label = label_of(study.study().protocol_name);
  base::NewFolder files(folder, base::NewFolder::Beside::Nothing);
  for (const Table& table : tables)
    files.add(fmt::format("data/study-{}_description-{}_data.csv", label, table.name), to_csv(table));
  files.add("dataset_description.json", description(study, facts, tables).dump(2) + "\n");
  files.add("README.md", readme(study, tables, label));
  files.add("CHANGES.md", changes_text(study, facts));
  files.add("materials/protocol.toml", study.study().protocol_text);
  files.add("materials/scene.toml", study.study().scene_text);
  refuse_problems("the Psych-DS data set", check_psych_ds(files.aside()));
  files.finish();
}

}  // namespace palpate::trials
