#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::analysis {

/// Columns of text with a name each, as a CSV file or a batch line gave them. Everything that is said about a
/// value tells where it stood.
struct DataTable {
  std::string source{};                             // "answers.csv"; "data" for a batch line
  std::vector<std::string> names{};                 // one for each column; empty: there was no header
  std::vector<std::vector<std::string>> columns{};  // all of one length
  std::vector<long> lines{};                        // where each row stood: 1 is the source's first line
  std::string why_no_header{};       // "'1' (column 2) is a number"; "" where nobody had to ask
  std::vector<std::string> notes{};  // what its reader decided, for a person to know
};

std::size_t rows(const DataTable& table);

/// "answers.csv:7": where a row stood.
std::string place_of(const DataTable& table, std::size_t row);

/// Runs a check of one row; the std::invalid_argument that it throws is thrown again with the row's place
/// before it.
template <typename Check>
void at_row(const DataTable& table, std::size_t row, const Check& check) {
  try {
    check();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(place_of(table, row) + ": " + error.what());
  }
}

/// What to say behind the columns of a table that look as if another character stood between them; else "".
std::string separator_hint(const DataTable& table);

bool has_column(const DataTable& table, std::string_view name);

/// The column of that name; without a header, the only column. Throws std::invalid_argument that lists the
/// columns there are.
const std::vector<std::string>& text_column(const DataTable& table, std::string_view name);

/// The same as numbers, whatever the locale. Throws std::invalid_argument, "answers.csv:7: level is
/// 'x'; ...", also for those that no result can be made of: read_number.hpp.
std::vector<double> number_column(const DataTable& table, std::string_view name);

/// The same as p values, which may be smaller than other numbers.
std::vector<double> p_value_column(const DataTable& table, std::string_view name);

/// The same as whole numbers from 0 on.
std::vector<long> count_column(const DataTable& table, std::string_view name);

/// The same as 0 or 1, which may be written as false and true, in any case: so do R and pandas.
std::vector<long> binary_column(const DataTable& table, std::string_view name);

/// Every column as 0 or 1 (outer: columns, inner: rows).
std::vector<std::vector<double>> binary_columns(const DataTable& table);

/// Every column as numbers (outer: columns, inner: rows).
std::vector<std::vector<double>> number_columns(const DataTable& table);

}  // namespace palpate::analysis
