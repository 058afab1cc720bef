#include "analysis/resampling/shuffled_rows.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace palpate::analysis {
namespace {

constexpr std::size_t kColumns = 16;  // 4 bits a sum, at the least
using Sums = std::array<std::uint64_t, kColumns>;
using States = std::vector<std::pair<std::uint64_t, double>>;  // packed sums and their probability

struct Packing {
  std::size_t columns = 0;
  int bits = 0;  // of one sum
};

std::uint64_t packed(const Sums& sums, const Packing& packing) {
  std::uint64_t state = 0;
  for (std::size_t j = 0; j < packing.columns; ++j) state = (state << packing.bits) | sums[j];
  return state;
}

Sums unpacked(std::uint64_t state, const Packing& packing) {
  const std::uint64_t mask = (std::uint64_t{1} << packing.bits) - 1;
  Sums sums{};
  for (std::size_t j = packing.columns; j-- > 0; state >>= packing.bits) sums[j] = state & mask;
  return sums;
}

long square_sum(const Sums& sums, std::size_t columns) {
  long total = 0;
  for (std::size_t j = 0; j < columns; ++j) total += static_cast<long>(sums[j] * sums[j]);
  return total;
}

std::vector<std::vector<long>> orders_of(std::vector<long> row) {
  std::vector<std::vector<long>> orders;
  std::ranges::sort(row);
  do orders.push_back(row);
  while (std::next_permutation(row.begin(), row.end()));
  return orders;
}

// In order of the states, so that the sums of probabilities are the same everywhere.
States add_row(const States& states, const std::vector<std::vector<long>>& orders, const Packing& packing) {
  std::unordered_map<std::uint64_t, double> reached;
  const double share = 1 / static_cast<double>(orders.size());
  const auto end = static_cast<std::ptrdiff_t>(packing.columns);
  for (const auto& [state, probability] : states) {
    const Sums before = unpacked(state, packing);
    for (const std::vector<long>& order : orders) {
      Sums sums = before;
      for (std::size_t j = 0; j < packing.columns; ++j) sums[j] += static_cast<std::uint64_t>(order[j]);
      std::sort(sums.begin(), sums.begin() + end);
      reached[packed(sums, packing)] += probability * share;
    }
  }
  States sorted(reached.begin(), reached.end());
  std::ranges::sort(sorted);
  return sorted;
}

// A row's smallest value is in every column's sum and tells nothing. Rows that are all alike go with it.
void strip(std::vector<std::vector<long>>& rows) {
  for (std::vector<long>& row : rows) {
    const long least = *std::ranges::min_element(row);
    for (long& value : row) value -= least;
  }
  std::erase_if(rows,
                [](const auto& row) { return std::ranges::all_of(row, [](long v) { return v == 0; }); });
}

double orders_count(std::vector<long> row) {
  std::ranges::sort(row);
  double count = 1.0;
  for (std::size_t i = 0, run = 0; i < row.size(); ++i) {
    run = i > 0 && row[i] == row[i - 1] ? run + 1 : 1;
    count *= static_cast<double>(i + 1) / static_cast<double>(run);
  }
  return count;
}

}  // namespace

std::optional<double> shuffled_rows_p(std::vector<std::vector<long>> rows, long most_steps) {
  strip(rows);
  if (rows.empty()) return 1.0;
  const std::size_t columns = rows.front().size();
  if (columns > kColumns) return std::nullopt;
  Sums seen{};
  std::uint64_t largest = 0;
  for (const std::vector<long>& row : rows) {
    assert(row.size() == columns);
    for (std::size_t j = 0; j < columns; ++j) seen[j] += static_cast<std::uint64_t>(row[j]);
    largest += static_cast<std::uint64_t>(*std::ranges::max_element(row));
  }
  const Packing packing{.columns = columns, .bits = static_cast<int>(std::bit_width(largest))};
  if (packing.columns * static_cast<std::size_t>(packing.bits) > 64) return std::nullopt;
  States states = {{0, 1.0}};
  double steps = 0.0;
  for (const std::vector<long>& row : rows) {
    steps += static_cast<double>(states.size()) * orders_count(row);
    if (steps > static_cast<double>(most_steps)) return std::nullopt;
    states = add_row(states, orders_of(row), packing);
  }
  double p = 0.0;
  for (const auto& [state, probability] : states) {
    if (square_sum(unpacked(state, packing), columns) >= square_sum(seen, columns)) p += probability;
  }
  return std::min(1.0, p);
}

}  // namespace palpate::analysis
