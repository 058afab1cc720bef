#include "app/commands/stats/read_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

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

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return lower;
}

bool is_missing_value(std::string_view field) {
  constexpr std::array<std::string_view, 6> kWords = {"nan", "-nan", "na", "n/a", "inf", "infinity"};
  std::string lower = in_lower_case(field);
  if (lower.starts_with("+inf") || lower.starts_with("-inf")) lower.erase(0, 1);
  return std::ranges::find(kWords, lower) != kWords.end();
}

/// Why a line cannot name the columns, "'10' (column 3) is a number"; nothing where it can.
std::optional<std::string> why_no_names(const CsvRow& row) {
  const auto& fields = row.fields;
  if (std::ranges::all_of(fields, &std::string::empty)) return "all its fields are empty";
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (analysis::is_numeral(fields[i]) && !is_missing_value(fields[i]))
      return fmt::format("'{}' (column {}) is a number", fields[i].substr(0, 60), i + 1);
    if (is_missing_value(fields[i]))
      return fmt::format("'{}' (column {}) stands for a number", fields[i], i + 1);
  }
  return std::nullopt;
}

/// Whether a column holds numbers that each are one more than the one before.
bool runs(const std::vector<std::string>& column) {
  std::optional<long> last;
  for (const std::string& text : column) {
    const auto value = analysis::read_count(text);
    if (!value || (last && *value != *last + 1)) return false;
    last = value;
  }
  return true;
}

/// Passes over an unnamed first column of running numbers; refuses any other column without a name, and a
/// name that is there twice.
void check_names(DataTable& table, long line) {
  if (table.names.size() > 1 && table.names.front().empty() && runs(table.columns.front())) {
    table.names.erase(table.names.begin());
    table.columns.erase(table.columns.begin());
    table.notes.push_back(fmt::format(
        "{}: the first column has no name and holds running numbers: it was passed over", table.source));
  }
  std::set<std::string> seen;
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    const std::string& name = table.names[i];
    if (name.empty()) {
      const bool hollow = std::ranges::all_of(table.columns[i], &std::string::empty);
      refuse(
          table.source, line,
          fmt::format("column {} has an empty name{}; accepted: a name for each column", i + 1,
                      hollow ? " and no values (a comma at the end of a line begins one more column)" : ""));
    }
    if (!seen.insert(name).second)
      refuse(table.source, line, fmt::format("the column '{}' is there twice", name));
  }
}

/// What may explain that a row has another number of fields than the first.
std::string ragged_hint(const CsvRow& first, const CsvRow& row) {
  for (const CsvRow* one : {&first, &row})
    if (one->fields.front().starts_with('#'))
      return fmt::format("; line {} looks like a comment, and a table holds none", one->line);
  for (const char separator : {';', '\t'})
    if (first.fields.front().find(separator) != std::string::npos)
      return fmt::format(
          "; the columns seem to be separated by {}, and numbers may have a decimal comma; accepted: commas "
          "between columns and a decimal point, as in 0.5,26,50",
          separator == ';' ? "';'" : "tabs");
  return "";
}

void check_widths(const std::string& file, const std::vector<CsvRow>& rows) {
  const std::size_t width = rows.front().fields.size();
  for (const CsvRow& row : rows) {
    const std::size_t found = row.fields.size();
    if (found == width) continue;
    refuse(file, row.line,
           fmt::format("{}; the first line has {}{}",
                       analysis::counted(static_cast<long>(found), "field", "fields"), width,
                       ragged_hint(rows.front(), row)));
  }
}

/// "sep=;", by which spreadsheets tell each other how the rest is written.
void refuse_separator_line(const std::string& file, const CsvRow& first) {
  if (!in_lower_case(first.fields.front()).starts_with("sep=") || first.fields.front().size() > 5) return;
  refuse(file, first.line,
         fmt::format("'{}' is a spreadsheet's note of its separator; accepted: the table without that line, "
                     "with commas between columns and a decimal point",
                     first.fields.front()));
}

}  // namespace

DataTable read_csv(const std::filesystem::path& file, FirstLine first_line) {
  const std::vector<CsvRow> found = base::split_csv(base::read_file(file, "a CSV file"), file.string());
  DataTable table{.source = file.string()};
  if (found.empty()) throw std::invalid_argument(file.string() + ": no rows of data");
  refuse_separator_line(table.source, found[0]);
  check_widths(table.source, found);
  const auto why_no_header = why_no_names(found[0]);
  const bool named = first_line == FirstLine::Names || (first_line == FirstLine::Unsaid && !why_no_header);
  if (named) table.names = found[0].fields;
  if (found.size() == (named ? 1U : 0U)) throw std::invalid_argument(file.string() + ": no rows of data");
  table.columns.resize(found[0].fields.size());
  for (std::size_t k = named ? 1 : 0; k < found.size(); ++k) {
    for (std::size_t column = 0; column < table.columns.size(); ++column)
      table.columns[column].push_back(found[k].fields[column]);
    table.lines.push_back(found[k].line);
  }
  if (named) {
    check_names(table, found[0].line);
  } else if (first_line == FirstLine::Unsaid) {
    table.why_no_header = *why_no_header;
    table.notes.push_back(
        fmt::format("{}: line {} was taken as data (no header), since {}; --header takes it as names, "
                    "--no-header says that it is data",
                    table.source, found[0].line, table.why_no_header));
  }
  return table;
}

void tell_notes(const DataTable& table) {
  for (const std::string& note : table.notes) fmt::print(stderr, "{}\n", note);
}

}  // namespace palpate::app
