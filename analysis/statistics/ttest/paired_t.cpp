#include "analysis/statistics/ttest/paired_t.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "analysis/numerics/rounding.hpp"
#include "base/text/counted.hpp"

namespace palpate::analysis {
namespace {

constexpr double kLargestT = 1e4;  // the series of the noncentral distribution grows with t^2

// The noncentrality at which P(T <= t) is `probability`; P falls as it grows.
double noncentrality_at(double t, double degrees, double probability) {
  const auto excess = [&](double delta) {
    return cdf(boost::math::non_central_t_distribution<>(degrees, delta), t) - probability;
  };
  const double step = 1 + std::abs(t) / 2;
  double lower = t - step, upper = t + step;
  while (excess(lower) < 0) lower -= step;
  while (excess(upper) > 0) upper += step;
  std::uintmax_t steps = 200;
  const auto found = boost::math::tools::toms748_solve(excess, lower, upper,
                                                       boost::math::tools::eps_tolerance<double>(40), steps);
  return (found.first + found.second) / 2;
}

Interval dz_interval(double t, double n, double level) {
  const double tail = (1 - level) / 2;
  if (std::abs(t) > kLargestT) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return {.lower = kNone, .upper = kNone, .level = level, .method = "t is beyond 10 000"};
  }
  return {.lower = noncentrality_at(t, n - 1, 1 - tail) / std::sqrt(n),
          .upper = noncentrality_at(t, n - 1, tail) / std::sqrt(n),
          .level = level,
          .method = "noncentral t"};
}

void validate(std::span<const double> differences, double level) {
  if (differences.size() < 2) {
    throw std::invalid_argument(
        fmt::format("{}; the t-test needs at least 2",
                    base::counted(std::ssize(differences), "difference", "differences")));
  }
  for (const double difference : differences) require_finite(difference, "difference");
  require_level(level, "confidence level");
  const std::vector<double> settled = settled_differences(differences);
  if (!std::ranges::all_of(settled, [&](double d) { return d == settled.front(); })) return;
  const bool rounded = std::ranges::any_of(differences, [&](double d) { return d != differences.front(); });
  throw std::invalid_argument(fmt::format("all differences are {}{}; the t-test needs some that differ",
                                          settled.front(), rounded ? " but for rounding" : ""));
}

}  // namespace

PairedTTest paired_t_test(std::span<const double> differences, double level) {
  validate(differences, level);
  PairedTTest test{.n = differences.size()};
  const double n = static_cast<double>(test.n), tail = (1 - level) / 2;
  test.degrees_of_freedom = static_cast<long>(test.n) - 1;
  test.mean = std::accumulate(differences.begin(), differences.end(), 0.0) / n;
  double squares = 0.0;
  for (const double difference : differences) squares += (difference - test.mean) * (difference - test.mean);
  test.standard_deviation = std::sqrt(squares / (n - 1));
  const double error = test.standard_deviation / std::sqrt(n);
  test.t = test.mean / error;
  const boost::math::students_t student(n - 1);
  test.p = {.greater = cdf(complement(student, test.t)),
            .less = cdf(student, test.t),
            .two_sided = 2 * cdf(complement(student, std::abs(test.t)))};
  const double half = quantile(complement(student, tail)) * error;
  test.interval = {
      .lower = test.mean - half, .upper = test.mean + half, .level = level, .method = "Student's t"};
  test.cohen_dz = test.mean / test.standard_deviation;
  test.dz_interval = dz_interval(test.t, n, level);
  test.method = {.name = "paired t-test, with Cohen's d_z", .source = "Student 1908; Cumming & Finch 2001"};
  return test;
}

}  // namespace palpate::analysis
