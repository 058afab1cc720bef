#include "analysis/statistics/randomisation/order_randomisation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/hypergeometric.hpp>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>

#include "analysis/binomial/counts_distribution.hpp"

namespace palpate::analysis {

void validate(const OrderStratum& s) {
  const auto within = [&](long count) { return count >= 0 && count <= s.trials; };
  // correct = a + (trials - correct_first - answers_first + a) with a trials both correct first and answered
  // 1
  const long twice_a = s.correct - s.trials + s.correct_first + s.answers_first;
  const long a = twice_a / 2;
  const bool whole = s.trials >= 1 && within(s.correct_first) && within(s.answers_first) && within(s.correct);
  if (whole && twice_a % 2 == 0 && a >= 0 && a <= std::min(s.correct_first, s.answers_first) &&
      a >= s.correct_first + s.answers_first - s.trials)
    return;
  throw std::invalid_argument(
      fmt::format("a stratum of {} trials, {} of them with the correct interval first, {} answered 1 and {} "
                  "correct contradicts itself",
                  s.trials, s.correct_first, s.answers_first, s.correct));
}

namespace {

/// Probability of 0, 1, ... trials correct answers in one stratum.
std::vector<double> of_stratum(const OrderStratum& s) {
  std::vector<double> probability(s.trials + 1, 0.0);
  const auto count = [](long n) { return static_cast<unsigned>(n); };
  const boost::math::hypergeometric_distribution<> both(count(s.correct_first), count(s.answers_first),
                                                        count(s.trials));
  const long fewest = std::max(0L, s.correct_first + s.answers_first - s.trials);
  for (long a = fewest; a <= std::min(s.correct_first, s.answers_first); ++a) {
    const long correct = 2 * a + s.trials - s.correct_first - s.answers_first;
    probability[correct] = boost::math::pdf(both, count(a));
  }
  return probability;
}

constexpr double kAlike = 1e-7;  // relative: probabilities this close count as equal, as in binomial_test()

PValues p_of(const std::vector<double>& probability, std::size_t seen) {
  PValues p{.greater = 0.0, .less = 0.0, .two_sided = 0.0};
  for (std::size_t k = 0; k < probability.size(); ++k) {
    if (k >= seen) p.greater += probability[k];
    if (k <= seen) p.less += probability[k];
    if (probability[k] <= probability[seen] * (1 + kAlike)) p.two_sided += probability[k];
  }
  for (double* value : {&p.greater, &p.less, &p.two_sided}) *value = std::min(1.0, *value);
  return p;
}

/// The p value of every number of correct answers, each sum taken once: p_of() for all would take the square
/// of their number.
std::vector<double> all_p(const std::vector<double>& probability, Side side) {
  std::vector<double> p(probability.size());
  if (side == Side::Greater) {
    std::partial_sum(probability.rbegin(), probability.rend(), p.rbegin());
  } else if (side == Side::Less) {
    std::partial_sum(probability.begin(), probability.end(), p.begin());
  } else {
    std::vector<double> sorted = probability, sums(probability.size());
    std::ranges::sort(sorted);
    std::partial_sum(sorted.begin(), sorted.end(), sums.begin());
    for (std::size_t k = 0; k < p.size(); ++k) {
      const auto above = std::ranges::upper_bound(sorted, probability[k] * (1 + kAlike));
      p[k] = sums[above - sorted.begin() - 1];
    }
  }
  return p;
}

/// The largest region whose p values are at most alpha.
CriticalNumber region(const std::vector<double>& probability, double alpha, Side side) {
  CriticalNumber critical{.trials = static_cast<long>(probability.size()) - 1, .alpha = alpha, .side = side};
  const double limit = alpha * (1 + 1e-12);
  double mean = 0.0;
  for (std::size_t k = 0; k < probability.size(); ++k) mean += static_cast<double>(k) * probability[k];
  critical.chance = mean / static_cast<double>(critical.trials);
  const std::vector<double> p = all_p(probability, side);
  for (std::size_t k = 0; k < probability.size(); ++k) {
    if (probability[k] == 0.0 || p[k] > limit) continue;
    const auto number = static_cast<long>(k);
    if (static_cast<double>(k) > mean && !critical.at_least) critical.at_least = number;
    if (static_cast<double>(k) < mean) critical.at_most = number;
    critical.size += probability[k];
  }
  return critical;
}

}  // namespace

OrderRandomisationTest order_randomisation_test(std::span<const OrderStratum> strata, double alpha,
                                                Side side) {
  require_level(alpha, "alpha");
  if (strata.empty())
    throw std::invalid_argument("no answers: the randomisation test needs one stratum at least");
  OrderRandomisationTest test;
  test.under_guessing = {1.0};
  std::map<std::array<long, 3>, std::vector<double>> known;  // most examinees are like others
  double variance = 0.0;
  for (const OrderStratum& stratum : strata) {
    validate(stratum);
    test.correct += stratum.correct;
    test.trials += stratum.trials;
    std::vector<double>& one = known[{stratum.trials, stratum.correct_first, stratum.answers_first}];
    if (one.empty()) one = of_stratum(stratum);
    test.under_guessing = convolve(test.under_guessing, one);
  }
  for (std::size_t k = 0; k < test.under_guessing.size(); ++k)
    test.expected += static_cast<double>(k) * test.under_guessing[k];
  for (std::size_t k = 0; k < test.under_guessing.size(); ++k)
    variance += std::pow(static_cast<double>(k) - test.expected, 2) * test.under_guessing[k];
  test.standard_deviation = std::sqrt(variance);
  test.p = p_of(test.under_guessing, test.correct);
  test.critical = region(test.under_guessing, alpha, side);
  test.method = {.name = "randomisation test over the admissible orders, exact",
                 .source = "Edgington & Onghena 2007"};
  test.critical.method = test.method;
  return test;
}

}  // namespace palpate::analysis
