#pragma once

#include <filesystem>

#include "analysis/description/data_table.hpp"

namespace palpate::app {

/// A CSV file as RFC 4180 has it: commas, quotes doubled, a line break within quotes allowed. Text is UTF-8;
/// its byte order mark, CRLF and blank lines at the end are tolerated. The first line names the columns;
/// where all its fields are numbers there is no header. Throws std::invalid_argument, "FILE:LINE: what was
/// found, what is accepted": no such file, text that is no UTF-8, ragged rows, a name twice, stray quotes,
/// nothing but a header.
analysis::DataTable read_csv(const std::filesystem::path& file);

}  // namespace palpate::app
