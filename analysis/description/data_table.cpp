#include "analysis/description/data_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "analysis/description/read_number.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

std::string header_hint(const DataTable& table) {
  if (table.why_no_header.empty()) return "";
  return fmt::format("; line {} was not taken as a header: {} (--header takes it as one)",
                     table.lines.front(), table.why_no_header);
}

std::size_t index_of(const DataTable& table, std::string_view name) {
  if (table.names.empty() && table.columns.size() == 1) return 0;
  const auto found = std::ranges::find(table.names, name);
  if (found != table.names.end()) return found - table.names.begin();
  if (table.names.empty()) {
    throw std::invalid_argument(fmt::format(
        "{}: no column '{}': the file has {} and no header line that names them{}", table.source, name,
        counted(static_cast<long>(table.columns.size()), "column", "columns"), header_hint(table)));
  }
  throw std::invalid_argument(fmt::format("{}: no column '{}'; there is {}{}", table.source, name,
                                          listed(table.names), separator_hint(table)));
}

template <typename Number, typename Read>
std::vector<Number> read_all(const DataTable& table, std::size_t column, const Read& read,
                             std::string_view accepted) {
  std::vector<Number> numbers;
  numbers.reserve(rows(table));
  for (std::size_t row = 0; row < rows(table); ++row) {
    const std::string& text = table.columns[column][row];
    const auto value = read(text);
    if (!value) {
      const std::string name = !table.names.empty()       ? table.names[column]
                               : table.columns.size() > 1 ? fmt::format("column {}", column + 1)
                                                          : "the value";
      throw std::invalid_argument(fmt::format("{}: {} is '{}'; accepted: {}{}", place_of(table, row), name,
                                              text.substr(0, 60), accepted,
                                              row == 0 ? header_hint(table) : ""));
    }
    numbers.push_back(*value);
  }
  return numbers;
}

constexpr std::string_view kBinaryInWords = "0 or 1 (also written as false or true)";

template <typename Number>
std::optional<Number> read_binary(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  const auto value = read_finite(text);
  if (lower == "false" || value == 0.0) return Number{0};
  if (lower == "true" || value == 1.0) return Number{1};
  return std::nullopt;
}

std::optional<double> read_probability(std::string_view text) {
  const auto value = read_finite(text);
  return value && *value >= 0 && *value <= 1 ? value : std::nullopt;
}

std::string number_in_words() {
  return fmt::format("a finite number with a decimal point, such as -0.25: {}", kMagnitudeBounds);
}

}  // namespace

std::size_t rows(const DataTable& table) {
  return table.lines.size();
}

std::string place_of(const DataTable& table, std::size_t row) {
  return fmt::format("{}:{}", table.source, table.lines[row]);
}

std::string separator_hint(const DataTable& table) {
  const bool other = std::ranges::any_of(
      table.names, [](const std::string& name) { return name.find_first_of(";\t") != std::string::npos; });
  return other ? "; columns are separated by commas, and numbers have a decimal point" : "";
}

bool has_column(const DataTable& table, std::string_view name) {
  return std::ranges::find(table.names, name) != table.names.end();
}

const std::vector<std::string>& text_column(const DataTable& table, std::string_view name) {
  return table.columns[index_of(table, name)];
}

std::vector<double> number_column(const DataTable& table, std::string_view name) {
  return read_all<double>(table, index_of(table, name), read_number, number_in_words());
}

std::vector<double> p_value_column(const DataTable& table, std::string_view name) {
  return read_all<double>(table, index_of(table, name), read_probability,
                          "a number from 0 to 1, such as 0.03");
}

std::vector<long> count_column(const DataTable& table, std::string_view name) {
  return read_all<long>(table, index_of(table, name), read_count,
                        fmt::format("a whole number {}", kCountBounds));
}

std::vector<long> binary_column(const DataTable& table, std::string_view name) {
  return read_all<long>(table, index_of(table, name), read_binary<long>, kBinaryInWords);
}

std::vector<std::vector<double>> binary_columns(const DataTable& table) {
  std::vector<std::vector<double>> all;
  for (std::size_t column = 0; column < table.columns.size(); ++column)
    all.push_back(read_all<double>(table, column, read_binary<double>, kBinaryInWords));
  return all;
}

std::vector<std::vector<double>> number_columns(const DataTable& table) {
  std::vector<std::vector<double>> all;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    all.push_back(read_all<double>(table, column, read_number, number_in_words()));
  }
  return all;
}

}  // namespace palpate::analysis
