#include "analysis/binomial/binomial_test.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>

#include "analysis/numerics/proportion_interval.hpp"

namespace palpate::analysis {
namespace {

using Binomial = boost::math::binomial_distribution<>;

double at_least(const Binomial& binomial, long k) {
  if (k <= 0) return 1.0;
  if (static_cast<double>(k) > binomial.trials()) return 0.0;
  return cdf(complement(binomial, static_cast<double>(k - 1)));
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

// P of all outcomes whose probability is at most `limit`. Outcomes become less likely away from the mode, so
// they are two tails.
double no_likelier_than(const Binomial& binomial, long n, double limit) {
  const auto rare = [&](long j) { return pdf(binomial, static_cast<double>(j)) <= limit; };
  const long top = std::min(n, static_cast<long>(static_cast<double>(n + 1) * binomial.success_fraction()));
  if (rare(top)) return 1.0;
  const long common = first_where(0, top, [&](long j) { return !rare(j); });
  const long tail = first_where(top, n + 1, rare);
  return at_most(binomial, common - 1) + (tail > n ? 0.0 : at_least(binomial, tail));
}

// Outcomes whose probabilities differ by less than this part count as equally likely, as in R's binom.test.
constexpr double kAlike = 1e-7;

}  // namespace

PValues binomial_p(long correct, long trials, double chance) {
  require_counts(correct, trials);
  require_level(chance, "chance");
  const Binomial binomial(static_cast<double>(trials), chance);
  const double seen = pdf(binomial, static_cast<double>(correct));
  return {.greater = at_least(binomial, correct),
          .less = at_most(binomial, correct),
          .two_sided = std::min(1.0, no_likelier_than(binomial, trials, seen * (1 + kAlike)))};
}

PValues binomial_mid_p(long correct, long trials, double chance) {
  require_counts(correct, trials);
  require_level(chance, "chance");
  const Binomial binomial(static_cast<double>(trials), chance);
  const double seen = pdf(binomial, static_cast<double>(correct));
  const double as_likely = no_likelier_than(binomial, trials, seen * (1 + kAlike));
  const double rarer = no_likelier_than(binomial, trials, seen * (1 - kAlike));
  return {.greater = at_least(binomial, correct + 1) + seen / 2,
          .less = at_most(binomial, correct - 1) + seen / 2,
          .two_sided = std::min(1.0, (as_likely + rarer) / 2)};
}

BinomialTest binomial_test(long correct, long trials, double chance, Side side, double level) {
  BinomialTest test{.correct = correct, .trials = trials, .chance = chance, .side = side};
  test.p = binomial_p(correct, trials, chance);
  test.proportion = static_cast<double>(correct) / static_cast<double>(trials);
  test.interval = clopper_pearson(correct, trials, level);
  test.bound = clopper_pearson_bound(correct, trials, side, level);
  test.wilson = wilson(correct, trials, level);
  test.jeffreys = jeffreys(correct, trials, level);
  test.mid_p = binomial_mid_p(correct, trials, chance);
  test.method = {.name = side == Side::TwoSided
                             ? "exact binomial test (two-sided: outcomes no likelier than the one seen)"
                             : "exact binomial test",
                 .source = "Clopper & Pearson 1934; two-sided rule as in R's binom.test"};
  return test;
}

}  // namespace palpate::analysis
