#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "trials/tables/table.hpp"

namespace palpate::trials {

constexpr std::string_view kMissing = "n/a";

/// RFC 4180: comma, LF, quotes doubled where needed; missing values are n/a. No byte-order mark.
std::string to_csv(const Table& table);

/// As BIDS has it: tabs, LF, no quotes; missing values are n/a.
std::string to_tsv(const Table& table);

/// The text of a cell before any quoting: numbers with all their digits, n/a where it is missing or empty.
std::string cell_text(const Value& value);

/// Free text as every table takes it: UTF-8 (bytes that are none become U+FFFD), control characters as
/// spaces, so that no reader meets a line break or a tab within a cell.
std::string plain_text(std::string_view text);

/// A delimited text, read as strictly as the strictest of its readers.
struct StrictTable {
  std::vector<std::string> header{};
  std::vector<std::vector<std::string>> rows{};
};

/// Reads a CSV (delimiter comma) or TSV text and adds to `problems`, "where:LINE: what": a byte-order mark,
/// CR, a missing last line end, blank or ragged rows, a delimiter at the end, empty cells, names that are not
/// snake_case or stand twice, quotes in the wrong place, \", text that is not UTF-8.
StrictTable read_strictly(std::string_view text, char delimiter, std::string_view where,
                          std::vector<std::string>& problems);

}  // namespace palpate::trials
