#include "trials/export/check_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <regex>
#include <set>

#include "trials/tables/delimited.hpp"

namespace palpate::trials {
namespace {

constexpr std::string_view kUtcPattern = R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d+)?Z)";

/// What is wrong with one cell; empty: nothing.
class CellCheck {
 public:
  explicit CellCheck(const CellRule& rule) : rule_(rule) {
    if (!rule.pattern.empty()) pattern_.emplace(fmt::format("^(?:{})$", rule.pattern), std::regex::optimize);
  }

  std::string operator()(const std::string& cell) {
    if (cell == last_) return verdict_;  // runs of one value are the rule
    last_ = cell;
    return verdict_ = judge(cell);
  }

 private:
  std::string judge(const std::string& cell) const {
    if (cell == kMissing) return rule_.may_be_missing ? "" : "is missing";
    if (cell.empty()) return "is empty";
    if (pattern_ && !std::regex_match(cell, *pattern_)) return "does not fit its pattern or levels";
    return rule_.numeric ? judge_number(cell) : "";
  }
  std::string judge_number(const std::string& cell) const {
    double value = 0;
    const auto read = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (read.ec != std::errc() || read.ptr != cell.data() + cell.size() || !std::isfinite(value))
      return "is no number";
    if (rule_.whole && value != std::floor(value)) return "is no whole number";
    if ((rule_.least && value < *rule_.least) || (rule_.most && value > *rule_.most))
      return "is out of range";
    return "";
  }

  const CellRule& rule_;
  std::optional<std::regex> pattern_{};
  std::string last_{}, verdict_ = "is empty";
};

CellRule rule_of(const Column& column) {
  return {.column = column.name,
          .numeric = column.kind == Kind::Whole || column.kind == Kind::Real,
          .whole = column.kind == Kind::Whole,
          .least = column.least,
          .most = column.most,
          .pattern = column.kind == Kind::Utc ? std::string(kUtcPattern) : pattern_of(column),
          .may_be_missing = column.may_be_missing};
}

void check_column(const Column& column, std::string_view where, std::vector<std::string>& problems) {
  const auto wrong = [&](std::string_view what) {
    problems.push_back(fmt::format("{}: column {} {}", where, column.name, what));
  };
  if (column.title.empty() || column.description.empty()) wrong("has no title or description");
  const bool measured = column.kind == Kind::Real || !column.unit.empty();  // a factor may be called _m
  if (measured && unit_of_name(column.name) != column.unit)
    wrong(fmt::format("has the unit \"{}\" and a name that says \"{}\"", column.unit,
                      unit_of_name(column.name)));
  if (!column.unit.empty() && column.kind != Kind::Real) wrong("has a unit and holds no numbers");
}

}  // namespace

std::string_view unit_of_name(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kUnits{
      {{"_ms", "ms"}, {"_hz", "Hz"}, {"_s", "s"}, {"_m", "m"}, {"_n", "N"}}};
  const auto found =
      std::ranges::find_if(kUnits, [&](const auto& unit) { return name.ends_with(unit.first); });
  return found == kUnits.end() ? std::string_view() : found->second;
}

void check_cells(const std::vector<CellRule>& rules, const std::vector<std::vector<std::string>>& rows,
                 std::string_view where, std::vector<std::string>& problems) {
  for (std::size_t i = 0; i < rules.size(); ++i) {
    CellCheck check(rules[i]);
    std::size_t wrong = 0;
    std::string first;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (i >= rows[r].size()) continue;  // a ragged row is told of where it is read
      const std::string what = check(rows[r][i]);
      if (what.empty() || ++wrong > 1) continue;
      first = fmt::format("row {}: \"{}\" {}", r + 1, rows[r][i], what);
    }
    if (wrong > 0)
      problems.push_back(fmt::format("{}: column {}, {}{}", where, rules[i].column, first,
                                     wrong > 1 ? fmt::format(" (and {} more)", wrong - 1) : ""));
  }
}

void check_table(const Table& table, std::vector<std::string>& problems) {
  std::vector<CellRule> rules;
  std::set<std::string> names;
  for (const Column& column : table.columns) {
    check_column(column, table.name, problems);
    if (!names.insert(column.name).second)
      problems.push_back(fmt::format("{}: column {} stands twice", table.name, column.name));
    rules.push_back(rule_of(column));
  }
  std::vector<std::vector<std::string>> rows;
  rows.reserve(table.rows.size());
  for (const auto& row : table.rows) {
    if (row.size() != table.columns.size())
      problems.push_back(
          fmt::format("{}: a row has {} cells of {}", table.name, row.size(), table.columns.size()));
    rows.emplace_back();
    for (const Value& value : row) rows.back().push_back(cell_text(value));
  }
  check_cells(rules, rows, table.name, problems);
}

}  // namespace palpate::trials
