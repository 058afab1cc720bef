#include "trials/tables/delimited.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/text/csv.hpp"
#include "base/text/utf8.hpp"

namespace palpate::trials {
namespace {

template <class Write>
std::string delimited(const Table& table, char delimiter, Write write) {
  std::string text;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (i > 0) text += delimiter;
    text += table.columns[i].name;
  }
  text += '\n';
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) text += delimiter;
      text += write(cell_text(row[i]));
    }
    text += '\n';
  }
  return text;
}

bool is_snake_case(std::string_view name) {
  return !name.empty() && name[0] >= 'a' && name[0] <= 'z' && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

/// Takes the cell at the front of `line`, quotes undone; the delimiter behind it stays.
std::string take_cell(std::string_view& line, char delimiter, bool& well_quoted) {
  if (line.empty() || line[0] != '"') {
    const std::size_t end = std::min(line.find(delimiter), line.size());
    std::string cell(line.substr(0, end));
    well_quoted &= delimiter != ',' || cell.find('"') == std::string::npos;
    line.remove_prefix(end);
    return cell;
  }
  well_quoted &= delimiter == ',';  // TSV knows no quotes
  std::string cell;
  std::size_t at = 1;
  for (; at < line.size(); ++at) {
    if (line[at] != '"')
      cell += line[at];
    else if (at + 1 < line.size() && line[at + 1] == '"')
      cell += line[at++];
    else
      break;
  }
  well_quoted &= at < line.size() && (at + 1 == line.size() || line[at + 1] == delimiter);
  line.remove_prefix(std::min(at + 1, line.size()));
  return cell;
}

std::vector<std::string> split(std::string_view line, char delimiter, bool& well_quoted) {
  std::vector<std::string> cells;
  while (true) {
    cells.push_back(take_cell(line, delimiter, well_quoted));
    if (line.empty()) return cells;
    line.remove_prefix(1);
  }
}

void check_header(const std::vector<std::string>& header, std::string_view where,
                  std::vector<std::string>& problems) {
  std::set<std::string> seen;
  for (const std::string& name : header) {
    if (!is_snake_case(name))
      problems.push_back(fmt::format("{}:1: column \"{}\" is not snake_case", where, name));
    if (!seen.insert(name).second)
      problems.push_back(fmt::format("{}:1: column {} stands twice", where, name));
  }
}

}  // namespace

std::string cell_text(const Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *whole);
  if (const auto* real = std::get_if<double>(&value)) return fmt::format("{}", *real);
  if (const auto* text = std::get_if<std::string>(&value); text && !text->empty()) return *text;
  return std::string(kMissing);
}

std::string plain_text(std::string_view text) {
  std::string plain;
  while (!text.empty()) {
    const std::size_t length = base::utf8_length(text);
    const auto first = static_cast<unsigned char>(text[0]);
    if (length == 0)
      plain += "\uFFFD";
    else if (first < 0x20 || first == 0x7F)
      plain += ' ';
    else
      plain += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  // A backslash before a quote, be it the one that closes the cell, is taken for an escape by some readers
  // and refused by Psych-DS.
  for (std::size_t at = 0; (at = plain.find("\\\"", at)) != std::string::npos; at += 2)
    plain.insert(at + 1, 1, ' ');
  if (plain.ends_with('\\')) plain += ' ';
  return plain;
}

std::string to_csv(const Table& table) {
  return delimited(table, ',', base::csv_field);
}

std::string to_tsv(const Table& table) {
  return delimited(table, '\t', [](std::string cell) {
    std::ranges::replace_if(
        cell, [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
    if (cell.starts_with('"')) cell.insert(0, 1, ' ');  // some readers take quotes at the front for quoting
    return cell;
  });
}

StrictTable read_strictly(std::string_view text, char delimiter, std::string_view where,
                          std::vector<std::string>& problems) {
  StrictTable table;
  const auto wrong = [&](std::size_t line, std::string_view what) {
    problems.push_back(fmt::format("{}:{}: {}", where, line, what));
  };
  if (text.starts_with("\xEF\xBB\xBF")) wrong(1, "begins with a byte-order mark");
  if (!base::is_utf8(text)) wrong(1, "is not UTF-8");
  if (!text.ends_with('\n')) wrong(1, "the last line has no end");
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    bool well_quoted = true;
    std::vector<std::string> cells = split(line, delimiter, well_quoted);
    if (line.empty()) wrong(number, "is blank");
    if (line.find('\r') != std::string_view::npos) wrong(number, "holds a carriage return");
    if (line.find("\\\"") != std::string_view::npos)
      wrong(number, "holds a quote with a backslash before it");
    if (!well_quoted) wrong(number, "a quote stands in the wrong place");
    if (line.ends_with(delimiter)) wrong(number, "ends with a delimiter");
    if (std::ranges::any_of(cells, &std::string::empty)) wrong(number, "has an empty cell; accepted: n/a");
    if (number == 1) {
      check_header(cells, where, problems);
      table.header = std::move(cells);
      continue;
    }
    if (cells.size() != table.header.size())
      wrong(number, fmt::format("has {} cells of {}", cells.size(), table.header.size()));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace palpate::trials
