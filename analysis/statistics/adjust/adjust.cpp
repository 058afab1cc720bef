#include "analysis/statistics/adjust/adjust.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace palpate::analysis {
namespace {

// Indices from the smallest p value to the largest.
std::vector<std::size_t> ascending(std::span<const double> p) {
  if (p.empty()) throw std::invalid_argument("no p values to adjust");
  for (const double value : p) {
    if (!(value >= 0 && value <= 1)) {
      throw std::invalid_argument(fmt::format("p value {}; accepted: 0 to 1", value));
    }
  }
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  return order;
}

// From the largest p value down, each times its factor and never above the one before.
template <typename Factor>
std::vector<double> step_up(std::span<const double> p, Factor factor) {
  const std::vector<std::size_t> order = ascending(p);
  std::vector<double> adjusted(p.size());
  double least = 1.0;
  for (std::size_t i = p.size(); i-- > 0;) {
    least = std::min(least, factor(i) * p[order[i]]);
    adjusted[order[i]] = least;
  }
  return adjusted;
}

}  // namespace

std::vector<double> holm(std::span<const double> p) {
  const std::vector<std::size_t> order = ascending(p);
  std::vector<double> adjusted(p.size());
  double most = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    most = std::max(most, std::min(1.0, static_cast<double>(p.size() - i) * p[order[i]]));
    adjusted[order[i]] = most;
  }
  return adjusted;
}

std::vector<double> hochberg(std::span<const double> p) {
  return step_up(p, [&](std::size_t i) { return static_cast<double>(p.size() - i); });
}

std::vector<double> benjamini_hochberg(std::span<const double> p) {
  return step_up(p,
                 [&](std::size_t i) { return static_cast<double>(p.size()) / static_cast<double>(i + 1); });
}

std::vector<double> adjusted(std::string_view method, std::span<const double> p) {
  if (method == "none") return {p.begin(), p.end()};
  if (method == "holm") return holm(p);
  if (method == "hochberg") return hochberg(p);
  if (method == "benjamini-hochberg") return benjamini_hochberg(p);
  throw std::invalid_argument(fmt::format(
      "p values are adjusted by '{}'; accepted: holm, hochberg, benjamini-hochberg, none", method));
}

}  // namespace palpate::analysis
