#include "analysis/statistics/sign/sign_test.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <vector>

#include "analysis/binomial/binomial_test.hpp"
#include "analysis/binomial/critical_number.hpp"
#include "analysis/numerics/infinity.hpp"
#include "analysis/numerics/proportion_interval.hpp"
#include "analysis/numerics/rounding.hpp"

namespace palpate::analysis {
namespace {

// The k-th smallest and k-th largest enclose the median unless fewer than k lie on one side of it.
Interval median_interval(const std::vector<double>& sorted, double level) {
  Interval interval{.lower = -kInfinity, .upper = kInfinity, .level = level, .method = "order statistics"};
  const long n = std::ssize(sorted);
  const auto rejected = critical_number(n, 0.5, (1 - level) / 2, Side::Less).at_most;
  if (!rejected) return interval;
  interval.lower = sorted[*rejected];
  interval.upper = sorted[n - 1 - *rejected];
  return interval;
}

}  // namespace

SignTest sign_test_of_counts(long positive, long negative, double level) {
  if (positive < 0 || negative < 0) {
    throw std::invalid_argument(
        fmt::format("{} positive and {} negative differences; counts start at 0", positive, negative));
  }
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  SignTest test{
      .n = static_cast<std::size_t>(positive + negative), .positive = positive, .negative = negative};
  if (test.n > 0) test.p = binomial_p(positive, positive + negative, 0.5);
  test.share_positive = kNone;
  test.share_interval = {.lower = 0.0, .upper = 1.0, .level = level, .method = "none: no signs"};
  if (test.n > 0) {
    test.share_positive = static_cast<double>(positive) / static_cast<double>(positive + negative);
    test.share_interval = clopper_pearson(positive, positive + negative, level);
  }
  test.median = kNone;
  test.interval = {.lower = kNone, .upper = kNone};
  test.method = {.name = "sign test, exact", .source = "Conover 1999, section 3.4"};
  return test;
}

SignTest sign_test(std::span<const double> given, double level) {
  if (given.empty()) throw std::invalid_argument("no differences; the sign test needs at least 1");
  require_level(level, "confidence level");
  for (const double difference : given) require_finite(difference, "difference");
  const std::vector<double> differences = settled_differences(given);
  const auto positive = std::ranges::count_if(differences, [](double d) { return d > 0; });
  const auto negative = std::ranges::count_if(differences, [](double d) { return d < 0; });
  SignTest test = sign_test_of_counts(positive, negative, level);
  test.n = differences.size();
  test.zeros = static_cast<long>(test.n) - positive - negative;
  std::vector<double> sorted = differences;
  std::ranges::sort(sorted);
  const std::size_t middle = sorted.size() / 2;
  test.median = sorted.size() % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
  test.interval = median_interval(sorted, level);
  return test;
}

}  // namespace palpate::analysis
