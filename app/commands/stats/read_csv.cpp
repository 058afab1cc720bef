#include "app/commands/stats/read_csv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

#include "analysis/description/read_number.hpp"
#include "analysis/words/words.hpp"
#include "base/files/read_file.hpp"
#include "base/text/csv.hpp"

namespace palpate::app {
namespace {

using analysis::DataTable;

using base::CsvRow;

[[noreturn]] void refuse(const std::string& file, long line, const std::string& what) {
  throw std::invalid_argument(fmt::format("{}:{}: {}", file, line, what));
}

bool is_number(const std::string& field) {
  return analysis::is_numeral(field);
}

// A line that names columns: no field is a number or a missing value.
bool is_header(const CsvRow& row) {
  return std::ranges::none_of(row.fields, [](const std::string& field) {
    std::string lower = field;
    for (char& c : lower) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    const bool missing = lower.empty() || lower == "nan" || lower == "na" || lower == "n/a";
    return missing || is_number(field) || lower.starts_with("inf") || lower.starts_with("-inf");
  });
}

void check_names(const std::string& file, const CsvRow& header) {
  std::set<std::string> seen;
  for (const std::string& name : header.fields) {
    if (!seen.insert(name).second)
      refuse(file, header.line, fmt::format("the column '{}' is there twice", name));
  }
}

}  // namespace

DataTable read_csv(const std::filesystem::path& file) {
  const std::vector<CsvRow> found = base::split_csv(base::read_file(file, "a CSV file"), file.string());
  DataTable table{.source = file.string()};
  const bool named = !found.empty() && is_header(found[0]);
  if (named) {
    check_names(file.string(), found[0]);
    table.names = found[0].fields;
  }
  if (found.size() == (named ? 1U : 0U)) throw std::invalid_argument(file.string() + ": no rows of data");
  const std::size_t width = found[0].fields.size();
  table.columns.resize(width);
  for (std::size_t k = named ? 1 : 0; k < found.size(); ++k) {
    if (found[k].fields.size() != width) {
      refuse(file.string(), found[k].line,
             fmt::format("{}; the first line has {}",
                         analysis::counted(static_cast<long>(found[k].fields.size()), "field", "fields"),
                         width));
    }
    for (std::size_t column = 0; column < width; ++column)
      table.columns[column].push_back(found[k].fields[column]);
    table.lines.push_back(found[k].line);
  }
  return table;
}

}  // namespace palpate::app
