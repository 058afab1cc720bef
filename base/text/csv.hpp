#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace palpate::base {

/// A row of a CSV file, and the line of the file on which it begins.
struct CsvRow {
  long line = 0;
  std::vector<std::string> fields{};
};

/// Rows of a CSV text (RFC 4180): commas, quotes around whole fields, line breaks within quotes, LF or CR LF;
/// blank lines are passed over, and so is a byte-order mark. Throws std::invalid_argument, "NAME:LINE: what",
/// for a byte that is no UTF-8, a quote within a field and a text that ends within quotes.
std::vector<CsvRow> split_csv(std::string_view text, const std::string& name);

/// A field as RFC 4180 writes it: in quotes, with those within doubled, where it holds a comma, a quote or a line
/// break; else as it is.
std::string csv_field(std::string_view text);

}  // namespace palpate::base
