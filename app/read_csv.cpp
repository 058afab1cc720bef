#include "app/read_csv.hpp"

#include <csv.h>
#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

#include "analysis/procedures/read_number.hpp"
#include "analysis/words.hpp"

namespace palpate::app {
namespace {

using analysis::DataTable;

struct Row {
  long line = 0;
  std::vector<std::string> fields;
};

struct Rows {
  std::vector<Row> rows;
  Row current;
  bool within_row = false;  // a quoted line break carries a row on to the next line
  long line = 1;            // of the character being read
};

[[noreturn]] void refuse(const std::string& file, long line, const std::string& what) {
  throw std::invalid_argument(fmt::format("{}:{}: {}", file, line, what));
}

std::string read_whole(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file)) {
    throw std::invalid_argument(file.string() + " is a folder; a CSV file is accepted");
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw std::invalid_argument(file.string() + ": cannot be opened: no such file, or no right to read it");
  }
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw std::system_error(std::make_error_code(std::errc::io_error), file.string());
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  return text;
}

// What passes here can be printed as JSON: it is the same check.
bool is_utf8(const std::string& text) {
  try {
    nlohmann::json(text).dump();
    return true;
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

void require_utf8(const std::string& file, const std::string& text) {
  if (is_utf8(text)) return;
  std::istringstream lines(text);
  std::string line;
  for (long number = 1; std::getline(lines, line); ++number) {
    if (is_utf8(line)) continue;
    refuse(file, number,
           "a byte that is no UTF-8; text is accepted in UTF-8 (in a spreadsheet: \"CSV UTF-8\")");
  }
}

void take_field(void* text, std::size_t size, void* rows) {
  Row& row = static_cast<Rows*>(rows)->current;
  row.fields.emplace_back(static_cast<const char*>(text), size);
}

void take_row(int, void* data) {
  Rows& rows = *static_cast<Rows*>(data);
  rows.rows.push_back(std::move(rows.current));
  rows.current = {};
  rows.within_row = false;
}

// A line at a time, so that every row knows where it began.
std::vector<Row> split(const std::string& file, const std::string& text) {
  csv_parser parser{};
  if (csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI) != 0) throw std::bad_alloc();
  const std::unique_ptr<csv_parser, decltype(&csv_free)> owner(&parser, csv_free);
  Rows rows;
  for (std::size_t first = 0; first < text.size(); ++rows.line) {
    const std::size_t size = std::min(text.find('\n', first), text.size() - 1) + 1 - first;
    const bool blank = text.find_first_not_of(" \t\r\n", first) >= first + size;
    if (!rows.within_row && !blank) {
      rows.current.line = rows.line;
      rows.within_row = true;
    }
    if (csv_parse(&parser, text.data() + first, size, take_field, take_row, &rows) != size) {
      refuse(file, rows.line,
             "a quote in the middle of a field; quotes go round a whole field and are doubled within it");
    }
    first += size;
  }
  if (csv_fini(&parser, take_field, take_row, &rows) != 0) {
    refuse(file, rows.line - 1, "the file ends within quotes");
  }
  return std::move(rows.rows);
}

bool is_number(const std::string& field) {
  return analysis::is_numeral(field);
}

// A line that names columns: no field is a number or a missing value.
bool is_header(const Row& row) {
  return std::none_of(row.fields.begin(), row.fields.end(), [](const std::string& field) {
    std::string lower = field;
    for (char& c : lower) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    const bool missing = lower.empty() || lower == "nan" || lower == "na" || lower == "n/a";
    return missing || is_number(field) || lower.starts_with("inf") || lower.starts_with("-inf");
  });
}

void check_names(const std::string& file, const Row& header) {
  std::set<std::string> seen;
  for (const std::string& name : header.fields) {
    if (!seen.insert(name).second) refuse(file, header.line, "the column '" + name + "' is there twice");
  }
}

}  // namespace

DataTable read_csv(const std::filesystem::path& file) {
  const std::string text = read_whole(file);
  require_utf8(file.string(), text);
  const std::vector<Row> found = split(file.string(), text);
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
