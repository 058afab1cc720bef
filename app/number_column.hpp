#pragma once

#include <filesystem>
#include <vector>

namespace palpate::app {

/// A CSV file of one column of numbers, with or without a header line. A decimal point, no thousands
/// separator; a UTF-8 byte order mark, quotes round a number, CRLF and blank lines at the end are tolerated.
/// Throws std::invalid_argument, "FILE:LINE: what was found, what is accepted".
std::vector<double> read_number_column(const std::filesystem::path& file);

}  // namespace palpate::app
