#include "base/text/csv.hpp"

#include <csv.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <new>
#include <stdexcept>

#include "base/text/utf8.hpp"

namespace palpate::base {
namespace {

struct Rows {
  std::vector<CsvRow> rows{};
  CsvRow current{};
  bool within_row = false;  // a quoted line break carries a row on to the next line
  long line = 1;            // of the character being read
};

[[noreturn]] void refuse(const std::string& name, long line, std::string_view what) {
  throw std::invalid_argument(fmt::format("{}:{}: {}", name, line, what));
}

/// The line that begins at `first`, with its line end.
std::string_view line_at(std::string_view text, std::size_t first) {
  return text.substr(first, std::min(text.find('\n', first), text.size() - 1) + 1 - first);
}

void require_utf8(std::string_view text, const std::string& name) {
  long number = 1;
  for (std::size_t first = 0; first < text.size(); first += line_at(text, first).size(), ++number)
    if (!is_utf8(line_at(text, first)))
      refuse(name, number,
             "a byte that is no UTF-8; text is accepted in UTF-8 (in a spreadsheet: \"CSV UTF-8\")");
}

void take_field(void* text, std::size_t size, void* rows) {
  static_cast<Rows*>(rows)->current.fields.emplace_back(static_cast<const char*>(text), size);
}

void take_row(int, void* data) {
  Rows& rows = *static_cast<Rows*>(data);
  rows.rows.push_back(std::move(rows.current));
  rows.current = {};
  rows.within_row = false;
}

/// A table of quoted fields with another separator begins with "level";
std::string_view separator_after_quote(std::string_view line) {
  if (line.find("\";") != std::string_view::npos) return " (columns are separated by commas, not by ';')";
  if (line.find("\"\t") != std::string_view::npos) return " (columns are separated by commas, not by tabs)";
  return "";
}

}  // namespace

// A line at a time, so that every row knows where it began.
std::vector<CsvRow> split_csv(std::string_view text, const std::string& name) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  require_utf8(text, name);
  csv_parser parser{};
  if (csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI) != 0) throw std::bad_alloc();
  const std::unique_ptr<csv_parser, decltype(&csv_free)> owner(&parser, csv_free);
  Rows rows;
  for (std::size_t first = 0; first < text.size(); ++rows.line) {
    const std::string_view line = line_at(text, first);
    const bool blank = line.find_first_not_of(" \t\r\n") == std::string_view::npos;
    if (!rows.within_row && !blank) {
      rows.current.line = rows.line;
      rows.within_row = true;
    }
    if (csv_parse(&parser, line.data(), line.size(), take_field, take_row, &rows) != line.size())
      refuse(name, rows.line,
             fmt::format("a quote in the middle of a field{}; quotes go round a whole field and are doubled "
                         "within it",
                         separator_after_quote(line)));
    first += line.size();
  }
  if (csv_fini(&parser, take_field, take_row, &rows) != 0)
    refuse(name, rows.line - 1, "the file ends within quotes");
  return std::move(rows.rows);
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace palpate::base
