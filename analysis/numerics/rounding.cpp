#include "analysis/numerics/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

namespace palpate::analysis {
namespace {

// Where each value stands in rising order of `key`.
template <typename Key>
std::vector<std::size_t> order_by(std::span<const double> values, const Key& key) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return key(values[i]); });
  return order;
}

}  // namespace

std::vector<double> settled_differences(std::span<const double> differences) {
  std::vector<double> settled(differences.begin(), differences.end());
  double greatest = 0.0, magnitude = 0.0;  // of all; of those alike so far
  for (const double difference : differences) greatest = std::max(greatest, std::abs(difference));
  const double alike = 1e-12 * greatest;
  for (const std::size_t i : order_by(differences, [](double d) { return std::abs(d); })) {
    if (std::abs(settled[i]) > magnitude + alike) magnitude = std::abs(settled[i]);
    settled[i] = magnitude == 0 ? 0.0 : std::copysign(magnitude, settled[i]);
  }
  return settled;
}

std::vector<double> settled_values(std::span<const double> values) {
  constexpr double kAlike = 4 * std::numeric_limits<double>::epsilon();
  std::vector<double> settled(values.begin(), values.end());
  double least = -std::numeric_limits<double>::infinity();
  for (const std::size_t i : order_by(values, [](double value) { return value; })) {
    if (!(settled[i] - least <= kAlike * std::abs(settled[i]))) least = settled[i];
    settled[i] = least;
  }
  return settled;
}

}  // namespace palpate::analysis
