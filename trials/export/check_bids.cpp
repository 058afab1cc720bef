// The rules of BIDS 1.9 for behavioural data, and a few of our own: every column described, no description
// without its column, every value held against levels and range, force files read to the last sample.
#include <fmt/format.h>
#include <zlib.h>

#include <map>
#include <memory>
#include <regex>
#include <set>

#include "trials/export/check_common.hpp"
#include "trials/export/check_values.hpp"
#include "trials/export/datasets.hpp"
#include "trials/tables/delimited.hpp"

namespace palpate::trials {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

bool is_column(const json& value) {
  return value.is_object() && value.contains("Description");
}

std::string escaped(const std::string& level) {
  std::string pattern;
  for (const char c : level) {
    if (std::string_view(".\\+*?()[]{}^$|/").find(c) != std::string_view::npos) pattern += '\\';
    pattern += c;
  }
  return pattern;
}

CellRule rule_of(const std::string& name, const json& column, const std::string& where, Problems& problems) {
  const std::string at = fmt::format("{}: {}", where, name);
  required_text(column, "LongName", at, problems);
  required_text(column, "Description", at, problems);
  CellRule rule{.column = name};
  if (const auto levels = column.find("Levels"); levels != column.end()) {
    if (!levels->is_object() || levels->empty()) problems.push_back(at + ": Levels is no object, or empty");
    for (const auto& [level, meaning] : levels->items())
      rule.pattern += (rule.pattern.empty() ? "" : "|") + escaped(level);
  }
  if (column.contains("Minimum") && column["Minimum"].is_number())
    rule.least = column["Minimum"].get<double>();
  if (column.contains("Maximum") && column["Maximum"].is_number())
    rule.most = column["Maximum"].get<double>();
  const std::string unit = column.value("Units", "");
  const std::string_view expected = name == "response_time" ? "s" : unit_of_name(name);
  rule.numeric = rule.least || rule.most || !unit.empty();
  if (!unit.empty() && unit != expected)
    problems.push_back(
        fmt::format("{}: Units \"{}\" is not \"{}\", which the name says", at, unit, expected));
  if (name == "response_time" && unit != "s") problems.push_back(at + ": Units is not s");
  return rule;
}

/// The rules of a table's columns, from its sidecar; both must have the same columns.
std::vector<CellRule> rules_of(const std::vector<std::string>& header, const json& sidecar,
                               const std::string& where, Problems& problems) {
  std::vector<CellRule> rules;
  for (const std::string& name : header) {
    const auto found = sidecar.find(name);
    if (found != sidecar.end() && is_column(*found)) {
      rules.push_back(rule_of(name, *found, where, problems));
    } else {
      problems.push_back(fmt::format("{}: column {} is not described", where, name));
      rules.push_back({.column = name});
    }
  }
  for (const auto& [name, value] : sidecar.items())
    if (is_column(value) && std::ranges::find(header, name) == header.end())
      problems.push_back(fmt::format("{}: {} is described and is no column", where, name));
  return rules;
}

fs::path sidecar_path(const fs::path& file, std::string_view suffix) {
  const std::string name = file.string();
  return name.substr(0, name.size() - suffix.size()) + ".json";
}

StrictTable check_tsv(const fs::path& root, const fs::path& file, const json& sidecar, Problems& problems) {
  StrictTable table = read_strictly(read_text(root, file, problems), '\t', file.string(), problems);
  if (table.rows.empty()) problems.push_back(file.string() + ": has no rows");
  check_cells(rules_of(table.header, sidecar, file.string(), problems), table.rows, file.string(), problems);
  return table;
}

/// @return the subjects that participants.tsv names
std::set<std::string> check_participants(const fs::path& root, Problems& problems) {
  const json sidecar = read_object(root, "participants.json", problems);
  const StrictTable table = check_tsv(root, "participants.tsv", sidecar, problems);
  std::set<std::string> subjects;
  if (table.header.empty() || table.header[0] != "participant_id") {
    problems.push_back("participants.tsv: participant_id is not the first column");
    return subjects;
  }
  static const std::regex kSubject("sub-[A-Za-z0-9]+");
  for (const auto& row : table.rows) {
    if (!std::regex_match(row[0], kSubject))
      problems.push_back(fmt::format("participants.tsv: \"{}\" is not sub-LABEL", row[0]));
    if (!subjects.insert(row[0]).second)
      problems.push_back(fmt::format("participants.tsv: {} stands twice", row[0]));
  }
  return subjects;
}

void check_description(const fs::path& root, Problems& problems) {
  constexpr const char* kFile = "dataset_description.json";
  const json description = read_object(root, kFile, problems);
  required_text(description, "Name", kFile, problems);
  static const std::regex kVersion("1\\.[0-9]+\\.[0-9]+");
  if (!std::regex_match(required_text(description, "BIDSVersion", kFile, problems), kVersion))
    problems.push_back(fmt::format("{}: BIDSVersion is not 1.N.N", kFile));
  const auto authors = description.find("Authors");
  if (authors == description.end() || !authors->is_array() ||
      !std::ranges::all_of(*authors,
                           [](const json& a) { return a.is_string() && !a.get<std::string>().empty(); }))
    problems.push_back(fmt::format("{}: Authors is no list of names", kFile));
}

std::string letters_and_digits(std::string text) {
  std::erase_if(text, [](char c) {
    return !((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'));
  });
  return text;
}

void check_task(const json& sidecar, const std::string& label, const std::string& where, Problems& problems) {
  if (letters_and_digits(required_text(sidecar, "TaskName", where, problems)) != label)
    problems.push_back(fmt::format("{}: TaskName is not that of the file, {}", where, label));
  required_text(sidecar, "TaskDescription", where, problems);
  required_text(sidecar, "Instructions", where, problems);
}

/// Calls `use` with every line; false when the file is damaged.
template <class Use>
bool each_line(const fs::path& file, Use use) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> gzip(gzopen(file.c_str(), "rb"), gzclose);
  if (!gzip || gzdirect(gzip.get()) != 0) return false;
  std::string rest;
  std::array<char, 1 << 16> block{};
  int read = 0;
  while ((read = gzread(gzip.get(), block.data(), block.size())) > 0) {
    rest.append(block.data(), read);
    std::size_t from = 0;
    for (std::size_t end = 0; (end = rest.find('\n', from)) != std::string::npos; from = end + 1)
      use(std::string_view(rest).substr(from, end - from));
    rest.erase(0, from);
  }
  int error = Z_OK;
  gzerror(gzip.get(), &error);
  return read == 0 && error == Z_OK && rest.empty();
}

void check_physio(const fs::path& root, const fs::path& file, const json& sidecar, Problems& problems) {
  const std::string where = file.string();
  const json frequency = sidecar.value("SamplingFrequency", json()),
             start = sidecar.value("StartTime", json());
  if (!frequency.is_number() || frequency.get<double>() <= 0)
    problems.push_back(where + ": SamplingFrequency is no positive number");
  if (!start.is_number()) problems.push_back(where + ": StartTime is no number");
  std::vector<std::string> header;
  for (const json& name : sidecar.value("Columns", json::array()))
    header.push_back(name.is_string() ? name.get<std::string>() : "");
  if (std::set(header.begin(), header.end()).size() != header.size() || header.empty())
    problems.push_back(where + ": Columns is missing, or names one twice");
  std::vector<CellRule> rules = rules_of(header, sidecar, where, problems);
  for (CellRule& rule : rules) rule.numeric = true;
  std::size_t lines = 0;
  std::vector<std::vector<std::string>> rows;
  const auto check_rows = [&] {
    check_cells(rules, rows, fmt::format("{}, after line {}", where, lines - rows.size()), problems);
    rows.clear();
  };
  const bool whole = each_line(root / file, [&](std::string_view line) {
    ++lines;
    std::vector<std::string>& cells = rows.emplace_back();
    for (std::size_t at = 0; at <= line.size();) {
      const std::size_t end = std::min(line.find('\t', at), line.size());
      cells.emplace_back(line.substr(at, end - at));
      at = end + 1;
    }
    if (cells.size() != header.size())
      problems.push_back(fmt::format("{}:{}: has {} cells of {}", where, lines, cells.size(), header.size()));
    if (rows.size() == 4096) check_rows();
  });
  check_rows();
  if (!whole) problems.push_back(where + ": is no whole gzip file that ends with a line");
  if (lines == 0) problems.push_back(where + ": has no samples");
}

/// One file of a subject. Returns whether it is data (rather than a sidecar).
void check_file(const fs::path& root, const fs::path& file, std::set<fs::path>& sidecars,
                Problems& problems) {
  static const std::regex kName(
      "(sub-[A-Za-z0-9]+)/(?:(ses-[A-Za-z0-9]+)/)?beh/(sub-[A-Za-z0-9]+)_(?:(ses-[A-Za-z0-9]+)_)?"
      "task-([A-Za-z0-9]+)(?:_acq-[A-Za-z0-9]+)?(?:_run-[0-9]+)?"
      "(_beh\\.tsv|_recording-[A-Za-z0-9]+_physio\\.tsv\\.gz|_beh\\.json|_recording-[A-Za-z0-9]+_physio\\."
      "json)");
  std::smatch match;
  const std::string name = file.string();
  if (!std::regex_match(name, match, kName))
    return problems.push_back(name + ": is no name of a behavioural file");
  if (match[1] != match[3] || match[2] != match[4])
    problems.push_back(name + ": the file's subject or session is not the folder's");
  if (name.ends_with(".json")) return;
  const fs::path beside = sidecar_path(file, name.ends_with(".gz") ? ".tsv.gz" : ".tsv");
  sidecars.insert(beside);
  const json sidecar = read_object(root, beside, problems);
  check_task(sidecar, match[5], beside.string(), problems);
  if (name.ends_with(".gz"))
    check_physio(root, file, sidecar, problems);
  else
    check_tsv(root, file, sidecar, problems);
}

}  // namespace

std::vector<std::string> check_bids(const fs::path& folder) {
  Problems problems;
  check_description(folder, problems);
  const std::set<std::string> subjects = check_participants(folder, problems);
  static const std::set<std::string> kAtTheTop{"dataset_description.json", "participants.tsv",
                                               "participants.json", "README.md", "CHANGES"};
  std::set<std::string> found;
  std::set<fs::path> sidecars, jsons;
  for (const fs::path& file : files_below(folder)) {
    const std::string first = file.begin()->string();
    if (first == "sourcedata" || kAtTheTop.contains(file.string())) continue;
    if (!first.starts_with("sub-")) {
      problems.push_back(file.string() + ": does not belong into a BIDS data set");
      continue;
    }
    found.insert(first);
    if (file.extension() == ".json") jsons.insert(file);
    check_file(folder, file, sidecars, problems);
  }
  for (const fs::path& sidecar : jsons)
    if (!sidecars.contains(sidecar)) problems.push_back(sidecar.string() + ": has no data file beside it");
  if (found != subjects)
    problems.push_back("participants.tsv: does not name just the subjects that have a folder");
  return problems;
}

}  // namespace palpate::trials
