#include "analysis/numerics/proportion_interval.hpp"

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <cmath>

#include "analysis/numerics/standard_normal.hpp"

namespace palpate::analysis {
namespace {

// The p at which P(X >= correct) = tail, and at which P(X <= correct) = tail.
double lower_bound(long correct, long trials, double tail) {
  if (correct == 0) return 0.0;
  const boost::math::beta_distribution<> beta(static_cast<double>(correct),
                                              static_cast<double>(trials - correct + 1));
  return quantile(beta, tail);
}

double upper_bound(long correct, long trials, double tail) {
  if (correct == trials) return 1.0;
  const boost::math::beta_distribution<> beta(static_cast<double>(correct + 1),
                                              static_cast<double>(trials - correct));
  return quantile(complement(beta, tail));
}

}  // namespace

Interval clopper_pearson(long correct, long trials, double level) {
  require_counts(correct, trials);
  require_level(level, "confidence level");
  const double tail = (1 - level) / 2;
  return {.lower = lower_bound(correct, trials, tail),
          .upper = upper_bound(correct, trials, tail),
          .level = level,
          .method = "Clopper-Pearson (exact)"};
}

Interval clopper_pearson_bound(long correct, long trials, Side side, double level) {
  if (side == Side::TwoSided) return clopper_pearson(correct, trials, level);
  require_counts(correct, trials);
  require_level(level, "confidence level");
  Interval bound{.lower = 0.0, .upper = 1.0, .level = level, .method = "Clopper-Pearson (exact), one-sided"};
  if (side == Side::Greater) bound.lower = lower_bound(correct, trials, 1 - level);
  if (side == Side::Less) bound.upper = upper_bound(correct, trials, 1 - level);
  return bound;
}

Interval wilson(long correct, long trials, double level) {
  require_counts(correct, trials);
  require_level(level, "confidence level");
  const double n = static_cast<double>(trials), p = static_cast<double>(correct) / n;
  const double z = critical_z(level);
  const double centre = (p + z * z / (2 * n)) / (1 + z * z / n);
  const double half = z / (1 + z * z / n) * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  return {.lower = correct == 0 ? 0.0 : std::max(0.0, centre - half),  // exactly, not to round-off
          .upper = correct == trials ? 1.0 : std::min(1.0, centre + half),
          .level = level,
          .method = "Wilson score"};
}

Interval jeffreys(long correct, long trials, double level) {
  require_counts(correct, trials);
  require_level(level, "confidence level");
  const double k = static_cast<double>(correct), n = static_cast<double>(trials), tail = (1 - level) / 2;
  const boost::math::beta_distribution<> posterior(k + 0.5, n - k + 0.5);
  return {.lower = correct == 0 ? 0.0 : quantile(posterior, tail),
          .upper = correct == trials ? 1.0 : quantile(complement(posterior, tail)),
          .level = level,
          .method = "Jeffreys"};
}

}  // namespace palpate::analysis
