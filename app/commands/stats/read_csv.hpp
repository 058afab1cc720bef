#pragma once

#include <filesystem>

#include "analysis/description/data_table.hpp"

namespace palpate::app {

/// What the first line of a CSV file is.
enum class FirstLine {
  Unsaid,  // names, unless one of its fields is a number or a missing value
  Names,
  Data
};

/// A CSV file as RFC 4180 has it: commas, quotes doubled, a line break within quotes allowed. Text is UTF-8;
/// its byte order mark, CRLF and blank lines at the end are tolerated. Where nobody said so and the first
/// line is taken for data, a note of the table tells it, with the reason. An unnamed first column of running
/// numbers (as pandas and R write them) is passed over, with a note. Throws std::invalid_argument,
/// "FILE:LINE: what was found, what is accepted": no such file, text that is no UTF-8, ragged rows, a name
/// twice or none, another separator, a line `sep=;`, stray quotes, nothing but a header.
analysis::DataTable read_csv(const std::filesystem::path& file, FirstLine first_line = FirstLine::Unsaid);

/// The table's notes on stderr.
void tell_notes(const analysis::DataTable& table);

}  // namespace palpate::app
