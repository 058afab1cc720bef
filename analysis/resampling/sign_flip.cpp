#include "analysis/resampling/sign_flip.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

#include "analysis/numerics/infinity.hpp"
#include "analysis/numerics/rounding.hpp"
#include "analysis/resampling/sign_sums.hpp"

namespace palpate::analysis {
namespace {

constexpr std::size_t kEnumerated = 20;  // 2^20 sign patterns: 10 ms
constexpr double kTableSteps = 5e7;      // of the exact distribution over a grid: 50 ms
constexpr long kSampledTerms =
    50'000'000;  // of the Monte Carlo sums: 0.1 s; thousands of differences get fewer

// The differences in whole steps of a common grid, 1/1 to 1/240: counts, and proportions of few trials.
std::optional<std::vector<long>> on_grid(std::span<const double> differences) {
  std::vector<long> steps(differences.size());
  for (int scale = 1; scale <= 240; ++scale) {
    bool whole = true;
    double total = 0.0;
    for (std::size_t i = 0; i < differences.size() && whole; ++i) {
      const double scaled = differences[i] * scale;
      total += std::abs(scaled);
      whole = total * static_cast<double>(differences.size()) < kTableSteps &&
              std::abs(scaled - std::round(scaled)) <= 1e-9 * std::max(1.0, std::abs(scaled));
      if (whole) steps[i] = std::lround(scaled);
    }
    if (whole) return steps;
  }
  return std::nullopt;
}

PValues p_on_grid(const std::vector<long>& steps) {
  std::vector<long> weights(steps.size());
  std::ranges::transform(steps, weights.begin(), [](long step) { return std::labs(step); });
  long positive = 0;  // the sum of the positive differences says as much as the sum of all
  for (const long step : steps) positive += std::max(0L, step);
  const std::vector<double> probability = sign_sum_distribution(weights);
  const auto seen = probability.begin() + positive;
  PValues p{.greater = std::min(1.0, std::reduce(seen, probability.end())),
            .less = std::min(1.0, std::reduce(probability.begin(), seen + 1))};
  p.two_sided = std::min(1.0, 2 * std::min(p.greater, p.less));
  return p;
}

// A subset J of the pairs has its signs flipped; empty ones have no mean and are the data themselves.
struct Subsets {
  std::vector<double> sums;   // of the differences in J
  std::vector<double> means;  // of those in J, non-empty J only
};

Subsets all_subsets(std::span<const double> d) {
  const std::size_t count = std::size_t{1} << d.size();
  Subsets subsets{.sums = std::vector<double>(count, 0.0), .means = {}};
  subsets.means.reserve(count);
  for (std::size_t mask = 1; mask < count; ++mask) {
    const std::size_t last = std::countr_zero(mask);
    subsets.sums[mask] = subsets.sums[mask & (mask - 1)] + d[last];
    subsets.means.push_back(subsets.sums[mask] / std::popcount(mask));
  }
  return subsets;
}

Subsets sampled_subsets(std::span<const double> d, long resamples, std::uint64_t seed) {
  Subsets subsets;
  std::mt19937_64 random(seed);
  for (long r = 0; r < resamples; ++r) {
    double sum = 0.0, members = 0.0;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < d.size(); ++i) {
      bits = i % 64 == 0 ? random() : bits >> 1;
      const auto flipped = static_cast<double>(bits & 1);
      sum += flipped * d[i];
      members += flipped;
    }
    subsets.sums.push_back(sum);
    if (members > 0) subsets.means.push_back(sum / members);
  }
  return subsets;
}

// Flipping J turns the sum T into T - 2 sum_J. The data themselves are one of the patterns: `added` is 1
// where the patterns are a sample that need not hold them (the add-one rule), 0 where they are all.
PValues p_of(const Subsets& subsets, std::span<const double> d, double added) {
  double total = 0.0, magnitude = 0.0;
  for (const double difference : d) {
    total += difference;
    magnitude += std::abs(difference);
  }
  const double tolerance = 1e-9 * magnitude;
  double greater = added, less = added, extreme = added;
  for (const double sum : subsets.sums) {
    const double flipped = total - 2 * sum;
    greater += flipped >= total - tolerance;
    less += flipped <= total + tolerance;
    extreme += std::abs(flipped) >= std::abs(total) - tolerance;
  }
  const double count = static_cast<double>(subsets.sums.size()) + added;
  return {.greater = greater / count, .less = less / count, .two_sided = extreme / count};
}

// The mean shift mu is not rejected at (1 - level)/2 while 1 + #{J: mean_J <= mu} exceeds that share of
// patterns.
Interval invert(Subsets subsets, double patterns, double level, std::string method) {
  Interval interval{.lower = -kInfinity, .upper = kInfinity, .level = level, .method = std::move(method)};
  const auto m = static_cast<std::ptrdiff_t>((1 - level) / 2 * patterns * (1 + 1e-12));
  std::vector<double>& means = subsets.means;
  if (m < 1 || m > std::ssize(means)) return interval;
  std::nth_element(means.begin(), means.begin() + (m - 1), means.end());
  interval.lower = means[m - 1];
  std::nth_element(means.begin(), means.end() - m, means.end());
  interval.upper = *(means.end() - m);
  return interval;
}

void validate(std::span<const double> differences, const SignFlipOptions& options) {
  if (differences.empty())
    throw std::invalid_argument("no differences; the permutation test needs at least 1");
  for (const double difference : differences) require_finite(difference, "difference");
  require_level(options.level, "confidence level");
  if (options.resamples >= 999) return;
  throw std::invalid_argument(fmt::format("{} resamples; at least 999 are needed", options.resamples));
}

}  // namespace

SignFlipTest sign_flip_test(std::span<const double> differences, const SignFlipOptions& options) {
  validate(differences, options);
  SignFlipTest test{.n = differences.size()};
  test.mean = std::reduce(differences.begin(), differences.end()) / static_cast<double>(test.n);
  const bool enumerate = test.n <= kEnumerated;
  const long resamples =
      std::min(options.resamples, std::max(999L, kSampledTerms / static_cast<long>(test.n)));
  Subsets subsets =
      enumerate ? all_subsets(differences) : sampled_subsets(differences, resamples, options.seed);
  const auto grid = enumerate ? std::nullopt : on_grid(differences);
  test.exact = enumerate || grid.has_value();
  test.p = grid ? p_on_grid(*grid) : p_of(subsets, differences, enumerate ? 0 : 1);
  if (!enumerate) test.seed = options.seed;
  if (!test.exact) test.resamples = resamples;
  const double patterns = static_cast<double>(subsets.sums.size()) + (enumerate ? 0 : 1);
  const std::vector<double> settled = settled_differences(differences);
  const bool alike =
      test.n > 1 && std::ranges::all_of(settled, [&](double d) { return d == settled.front(); });
  const std::string sampled = fmt::format("{} random subset means, seed {}", resamples, options.seed);
  test.interval = invert(std::move(subsets), patterns, options.level,
                         "test inversion over " + (enumerate ? "all subset means" : sampled));
  if (alike) {  // every subset has the same mean: an interval without width would feign certainty
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    test.interval = {
        .lower = kNone, .upper = kNone, .level = options.level, .method = "none: all differences are equal"};
  }
  test.method = {
      .name = test.exact ? "sign-flip permutation test, exact"
                         : fmt::format("sign-flip permutation test, Monte Carlo with {} resamples, seed {}, "
                                       "add-one rule",
                                       resamples, options.seed),
      .source = test.exact ? "Fisher 1935" : "Fisher 1935; Phipson & Smyth 2010"};
  return test;
}

}  // namespace palpate::analysis
