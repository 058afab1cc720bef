#include "analysis/statistics/binomial_test.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>

#include "analysis/statistics/proportion_interval.hpp"

namespace palpate::analysis {
namespace {

using Binomial = boost::math::binomial_distribution<>;

double at_least(const Binomial& binomial, long k) {
  return k <= 0 ? 1.0 : cdf(complement(binomial, static_cast<double>(k - 1)));
}

double at_most(const Binomial& binomial, long k) {
  return k < 0 ? 0.0 : cdf(binomial, static_cast<double>(k));
}

// First k in [first, last) at which `holds` is true, given that it is false before and true from there on.
template <typename Predicate>
long first_where(long first, long last, Predicate holds) {
  while (first < last) {
    const long middle = first + (last - first) / 2;
    if (holds(middle)) {
      last = middle;
    } else {
      first = middle + 1;
    }
  }
  return first;
}

// Outcomes become less likely away from the mean, so those no likelier than k on the far side are a tail.
double two_sided(const Binomial& binomial, long k, long n) {
  const double mean = static_cast<double>(n) * binomial.success_fraction(), x = static_cast<double>(k);
  const double limit = pdf(binomial, x) * (1 + 1e-7);
  const auto rare = [&](long j) { return pdf(binomial, static_cast<double>(j)) <= limit; };
  if (x == mean) return 1.0;
  if (x < mean) {
    const long tail = first_where(static_cast<long>(std::ceil(mean)), n + 1, rare);
    return at_most(binomial, k) + (tail > n ? 0.0 : at_least(binomial, tail));
  }
  const long common =
      first_where(0, static_cast<long>(std::floor(mean)) + 1, [&](long j) { return !rare(j); });
  return at_most(binomial, common - 1) + at_least(binomial, k);
}

}  // namespace

PValues binomial_p(long correct, long trials, double chance) {
  require_counts(correct, trials);
  require_level(chance, "chance");
  const Binomial binomial(static_cast<double>(trials), chance);
  return {.greater = at_least(binomial, correct),
          .less = at_most(binomial, correct),
          .two_sided = std::min(1.0, two_sided(binomial, correct, trials))};
}

BinomialTest binomial_test(long correct, long trials, double chance, Side side, double level) {
  BinomialTest test{.correct = correct, .trials = trials, .chance = chance, .side = side};
  test.p = binomial_p(correct, trials, chance);
  test.proportion = static_cast<double>(correct) / static_cast<double>(trials);
  test.interval = clopper_pearson(correct, trials, level);
  test.bound = clopper_pearson_bound(correct, trials, side, level);
  test.wilson = wilson(correct, trials, level);
  test.method = {.name = side == Side::TwoSided
                             ? "exact binomial test (two-sided: outcomes no likelier than the one seen)"
                             : "exact binomial test",
                 .source = "Clopper & Pearson 1934; two-sided rule as in R's binom.test"};
  return test;
}

}  // namespace palpate::analysis
