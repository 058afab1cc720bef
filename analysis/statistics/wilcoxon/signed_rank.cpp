#include "analysis/statistics/wilcoxon/signed_rank.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "analysis/numerics/infinity.hpp"
#include "analysis/numerics/rounding.hpp"
#include "analysis/resampling/sign_sums.hpp"

namespace palpate::analysis {
namespace {

constexpr std::size_t kExact = 500;     // 500 ranks: a table of 250 000 sums, 60 ms
constexpr std::size_t kLargest = 5000;  // 12.5 million means of pairs

struct Ranks {
  std::vector<long> doubled;  // twice the mid-rank of each difference that is not zero
  std::vector<bool> positive;
  bool ties = false;
};

Ranks rank(std::span<const double> differences, Zeros zeros) {
  std::vector<double> sorted;
  for (const double d : differences) {
    if (d != 0 || zeros == Zeros::Pratt) sorted.push_back(d);
  }
  std::ranges::sort(sorted, [](double a, double b) { return std::abs(a) < std::abs(b); });
  Ranks ranks;
  for (std::size_t first = 0, last = 0; first < sorted.size(); first = last) {
    while (last < sorted.size() && std::abs(sorted[last]) == std::abs(sorted[first])) ++last;
    if (sorted[first] == 0) continue;
    if (last - first > 1) ranks.ties = true;
    for (std::size_t i = first; i < last; ++i) {
      ranks.doubled.push_back(static_cast<long>(first + 1 + last));  // ranks first+1 .. last
      ranks.positive.push_back(sorted[i] > 0);
    }
  }
  return ranks;
}

struct DoubledSums {
  long positive = 0, all = 0;  // of the ranks
};

DoubledSums doubled_sums(const Ranks& ranks) {
  DoubledSums sums;
  for (std::size_t i = 0; i < ranks.doubled.size(); ++i) {
    sums.all += ranks.doubled[i];
    if (ranks.positive[i]) sums.positive += ranks.doubled[i];
  }
  return sums;
}

double rank_biserial(const Ranks& ranks) {
  const auto [positive, all] = doubled_sums(ranks);
  return all > 0 ? static_cast<double>(2 * positive - all) / static_cast<double>(all) : 0.0;
}

PValues exact_p(const Ranks& ranks, long doubled_v) {
  const std::vector<double> probability = sign_sum_distribution(ranks.doubled);
  const auto seen = probability.begin() + doubled_v;
  PValues p{.greater = std::min(1.0, std::reduce(seen, probability.end())),
            .less = std::min(1.0, std::reduce(probability.begin(), seen + 1))};
  p.two_sided = std::min(1.0, 2 * std::min(p.greater, p.less));
  return p;
}

// Under the hypothesis V has mean sum(r)/2 and variance sum(r^2)/4, whatever the ties and the zeros.
PValues normal_p(const Ranks& ranks, double v) {
  double mean = 0.0, variance = 0.0;
  for (const long doubled : ranks.doubled) {
    const double r = 0.5 * static_cast<double>(doubled);
    mean += r / 2;
    variance += r * r / 4;
  }
  const boost::math::normal normal(0.0, std::sqrt(variance));
  PValues p{.greater = cdf(complement(normal, v - mean - 0.5)), .less = cdf(normal, v - mean + 0.5)};
  p.two_sided = std::min(1.0, 2 * std::min(p.greater, p.less));
  return p;
}

// The largest m with P(V < m) <= tail for n ranks without ties: the interval ends at the m-th mean of pairs.
std::size_t rank_of_end(std::size_t n, double tail) {
  if (n > kExact) {
    const double count = static_cast<double>(n), mean = count * (count + 1) / 4;
    const double deviation = std::sqrt(count * (count + 1) * (2 * count + 1) / 24);
    return static_cast<std::size_t>(std::max(0.0, quantile(boost::math::normal(mean, deviation), tail)));
  }
  std::vector<long> weights(n);
  std::iota(weights.begin(), weights.end(), 1L);
  const std::vector<double> probability = sign_sum_distribution(weights);
  double below = 0.0;
  std::size_t m = 0;
  while (below + probability[m] <= tail * (1 + 1e-12)) below += probability[m++];
  return m;
}

void estimate(std::span<const double> d, double level, SignedRankTest& test) {
  std::vector<double> means;
  means.reserve(d.size() * (d.size() + 1) / 2);
  for (std::size_t i = 0; i < d.size(); ++i) {
    for (std::size_t j = i; j < d.size(); ++j) means.push_back((d[i] + d[j]) / 2);
  }
  const auto smallest = [&means](std::size_t rank) {  // from 0
    const auto at = means.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(means.begin(), at, means.end());
    return *at;
  };
  test.pseudo_median = (smallest((means.size() - 1) / 2) + smallest(means.size() / 2)) / 2;

  test.interval = {.lower = -kInfinity,
                   .upper = kInfinity,
                   .level = level,
                   .method = "means of pairs, Hodges & Lehmann 1963"};
  const std::size_t m = rank_of_end(d.size(), (1 - level) / 2);
  if (m < 1) return;
  test.interval.lower = smallest(m - 1);
  test.interval.upper = smallest(means.size() - m);
}

void validate_ranks(std::span<const double> differences, double level) {
  if (differences.empty())
    throw std::invalid_argument("no differences; the signed-rank test needs at least 1");
  if (differences.size() > kLargest) {
    throw std::invalid_argument(
        fmt::format("{} differences; the signed-rank test takes up to {}", differences.size(), kLargest));
  }
  for (const double difference : differences) require_finite(difference, "difference");
  require_level(level, "confidence level");
}

}  // namespace

Zeros zeros_from_name(std::string_view name) {
  if (name == "drop") return Zeros::Drop;
  if (name == "pratt") return Zeros::Pratt;
  throw std::invalid_argument(fmt::format("rule for zeros is '{}'; accepted: drop, pratt", name));
}

std::string_view name_of(Zeros zeros) {
  return zeros == Zeros::Drop ? "drop" : "pratt";
}

SignedRankTest signed_rank_test(std::span<const double> given, Zeros zeros, double level) {
  validate_ranks(given, level);
  const std::vector<double> differences = settled_differences(given);
  const Ranks ranks = rank(differences, zeros);
  SignedRankTest test{.n = differences.size(),
                      .zeros = differences.size() - ranks.doubled.size(),
                      .ties = ranks.ties,
                      .zeros_rule = zeros};
  const auto [positive, all] = doubled_sums(ranks);
  test.v = 0.5 * static_cast<double>(positive);
  test.v_max = 0.5 * static_cast<double>(all);
  test.rank_biserial = rank_biserial(ranks);
  test.exact = ranks.doubled.size() <= kExact;
  test.p = test.exact ? exact_p(ranks, positive) : normal_p(ranks, test.v);
  estimate(differences, level, test);
  test.method = {
      .name = fmt::format("Wilcoxon signed-rank test, {}, {}",
                          test.exact ? "exact" : "normal approximation with tie and continuity correction",
                          zeros == Zeros::Drop ? "zeros dropped" : "zeros by Pratt's rule"),
      .source = zeros == Zeros::Drop ? "Wilcoxon 1945" : "Wilcoxon 1945; Pratt 1959"};
  return test;
}

Interval rank_biserial_interval(std::span<const double> given, Zeros zeros, const BootstrapOptions& options) {
  validate_ranks(given, options.level);
  const std::vector<double> differences = settled_differences(given);
  std::vector<double> drawn(differences.size());
  const auto statistic = [&](std::span<const std::size_t> chosen) {
    std::ranges::transform(chosen, drawn.begin(), [&](std::size_t i) { return differences[i]; });
    return rank_biserial(rank(drawn, zeros));
  };
  return bootstrap_interval(differences.size(), statistic, options);
}

}  // namespace palpate::analysis
