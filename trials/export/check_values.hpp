#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "trials/tables/table.hpp"

namespace palpate::trials {

/// What a cell's text must fulfil, as a codebook in any format tells it.
struct CellRule {
  std::string column{};
  bool numeric = false, whole = false;
  std::optional<double> least{}, most{};
  std::string pattern{};  // of the whole cell; empty: any
  bool may_be_missing = true;
};

/// Adds a problem for every column in which a cell breaks its rule: the first such cell, and how many there
/// are. `rows` hold the cells in the order of the rules.
void check_cells(const std::vector<CellRule>& rules, const std::vector<std::vector<std::string>>& rows,
                 std::string_view where, std::vector<std::string>& problems);

/// A table against its own codebook: cells, number of cells in a row, names and descriptions of columns. The
/// name of what is measured ends in its unit.
void check_table(const Table& table, std::vector<std::string>& problems);

/// The unit that a column's name ends in: _s, _ms, _m, _n, _hz; empty: none.
std::string_view unit_of_name(std::string_view name);

}  // namespace palpate::trials
