// The rules of Psych-DS 1.5, and a few of our own: every value is held against its variable's range and
// pattern.
#include <fmt/format.h>

#include <array>
#include <map>
#include <regex>
#include <set>

#include "trials/export/check_common.hpp"
#include "trials/export/check_values.hpp"
#include "trials/export/datasets.hpp"
#include "trials/tables/delimited.hpp"

namespace palpate::trials {
namespace {

using nlohmann::json;

constexpr const char* kDescription = "dataset_description.json";
constexpr std::array<std::string_view, 9> kKeywords{"study",     "site",  "subject",  "session",    "task",
                                                    "condition", "trial", "stimulus", "description"};

std::optional<double> optional_number(const json& variable, const char* key, std::string_view where,
                                      Problems& problems) {
  const auto found = variable.find(key);
  if (found == variable.end()) return std::nullopt;
  if (found->is_number()) return found->get<double>();
  problems.push_back(fmt::format("{}: {} is no number", where, key));
  return std::nullopt;
}

std::string optional_text(const json& variable, const char* key) {
  const auto found = variable.find(key);
  return found != variable.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// Keeps only patterns that hold the whole cell and can be compiled.
std::string whole_pattern(const json& variable, std::string_view where, Problems& problems) {
  const std::string pattern = optional_text(variable, "valuePattern");
  if (pattern.empty()) return {};
  try {
    const std::regex compiled(pattern);
    if (pattern.starts_with('^') && pattern.ends_with('$')) return pattern.substr(1, pattern.size() - 2);
    problems.push_back(fmt::format("{}: valuePattern does not run from ^ to $", where));
  } catch (const std::regex_error&) {
    problems.push_back(fmt::format("{}: valuePattern is no regular expression", where));
  }
  return {};
}

std::map<std::string, CellRule> read_variables(const json& description, Problems& problems) {
  std::map<std::string, CellRule> rules;
  const auto found = description.find("variableMeasured");
  if (found == description.end() || !found->is_array() || found->empty()) {
    problems.push_back(fmt::format("{}: variableMeasured is missing or empty", kDescription));
    return rules;
  }
  for (const json& variable : *found) {
    if (!variable.is_object()) {
      problems.push_back(fmt::format("{}: a variable is no object", kDescription));
      continue;
    }
    const std::string name = required_text(variable, "name", kDescription, problems);
    const std::string where = fmt::format("{}: {}", kDescription, name);
    required_text(variable, "description", where, problems);
    if (optional_text(variable, "@type") != "PropertyValue")
      problems.push_back(where + ": @type is not PropertyValue");
    CellRule rule{.column = name};
    rule.least = optional_number(variable, "minValue", where, problems);
    rule.most = optional_number(variable, "maxValue", where, problems);
    rule.pattern = whole_pattern(variable, where, problems);
    const std::string unit = optional_text(variable, "unitText");
    rule.numeric = rule.least || rule.most || !unit.empty();
    if (!unit.empty() && unit != unit_of_name(name))
      problems.push_back(fmt::format("{}: unitText \"{}\" is not the unit in the name", where, unit));
    if (!rules.emplace(name, rule).second) problems.push_back(where + ": is described twice");
  }
  return rules;
}

void check_name(const std::string& name, Problems& problems) {
  static const std::regex kName("([a-z]+-[a-zA-Z0-9]+)(_[a-z]+-[a-zA-Z0-9]+)*_data\\.csv");
  if (!std::regex_match(name, kName)) {
    problems.push_back(
        fmt::format("data/{}: the name is not keyword-value[_keyword-value...]_data.csv", name));
    return;
  }
  std::set<std::string> seen;
  for (std::size_t at = 0; at < name.rfind("_data.csv");) {
    const std::size_t dash = name.find('-', at);
    const std::string keyword = name.substr(at, dash - at);
    if (std::ranges::find(kKeywords, keyword) == kKeywords.end())
      problems.push_back(fmt::format("data/{}: {} is no keyword of Psych-DS", name, keyword));
    if (!seen.insert(keyword).second)
      problems.push_back(fmt::format("data/{}: {} stands twice", name, keyword));
    at = name.find('_', dash) + 1;
  }
}

void check_data(const std::string& text, const std::string& where,
                const std::map<std::string, CellRule>& rules, std::set<std::string>& used,
                Problems& problems) {
  const StrictTable table = read_strictly(text, ',', where, problems);
  if (table.rows.empty()) problems.push_back(where + ": has no rows");
  std::vector<CellRule> of_columns;
  for (const std::string& name : table.header) {
    used.insert(name);
    const auto rule = rules.find(name);
    if (rule == rules.end())
      problems.push_back(fmt::format("{}: column {} is not described in variableMeasured", where, name));
    of_columns.push_back(rule == rules.end() ? CellRule{.column = name} : rule->second);
  }
  check_cells(of_columns, table.rows, where, problems);
}

}  // namespace

std::vector<std::string> check_psych_ds(const std::filesystem::path& folder) {
  Problems problems;
  const json description = read_object(folder, kDescription, problems);
  if (required_text(description, "@context", kDescription, problems) != "https://schema.org")
    problems.push_back(fmt::format("{}: @context is not https://schema.org", kDescription));
  if (required_text(description, "@type", kDescription, problems) != "Dataset")
    problems.push_back(fmt::format("{}: @type is not Dataset", kDescription));
  required_text(description, "name", kDescription, problems);
  required_text(description, "description", kDescription, problems);
  const auto rules = read_variables(description, problems);

  std::set<std::string> used;
  bool any = false;
  for (const auto& file : files_below(folder)) {
    if (*file.begin() != "data") continue;
    any = true;
    check_name(file.lexically_relative("data").string(), problems);
    check_data(read_text(folder, file, problems), file.string(), rules, used, problems);
  }
  if (!any) problems.push_back("data: holds no file");
  for (const auto& [name, rule] : rules)
    if (!used.contains(name))
      problems.push_back(fmt::format("{}: {} is described and stands in no file", kDescription, name));
  return problems;
}

}  // namespace palpate::trials
