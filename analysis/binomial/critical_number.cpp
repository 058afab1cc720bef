#include "analysis/binomial/critical_number.hpp"

#include "analysis/binomial/binomial_power.hpp"
#include "analysis/binomial/binomial_test.hpp"

namespace palpate::analysis {
namespace {

// P falls as k moves outward from chance, so the edge of the region is found by halving.
template <typename PValue>
std::optional<long> smallest(long first, long last, double limit, PValue p) {
  if (first > last || p(last) > limit) return std::nullopt;
  while (first < last) {
    const long middle = first + (last - first) / 2;
    if (p(middle) <= limit) {
      last = middle;
    } else {
      first = middle + 1;
    }
  }
  return last;
}

}  // namespace

CriticalNumber critical_number(long trials, double chance, double alpha, Side side) {
  require_counts(0, trials);
  require_level(chance, "chance");
  require_level(alpha, "alpha");
  CriticalNumber critical{.trials = trials, .chance = chance, .alpha = alpha, .side = side};
  const double limit = alpha * (1 + 1e-12);
  const long mean = static_cast<long>(static_cast<double>(trials) * chance);
  const auto p = [&](long k) { return binomial_p(k, trials, chance).of(side); };
  if (side == Side::Greater) critical.at_least = smallest(0, trials, limit, p);
  if (side == Side::TwoSided) critical.at_least = smallest(mean + 1, trials, limit, p);
  if (side != Side::Greater) {
    const auto mirrored = [&](long j) { return p(trials - j); };
    const long inward = side == Side::Less ? 0 : trials - mean;
    const auto j = smallest(inward, trials, limit, mirrored);
    if (j) critical.at_most = trials - *j;
  }
  critical.size = rejection_probability(critical, chance);
  critical.method = {.name = "critical number of the exact binomial test",
                     .source = "binomial distribution; ISO 5495 tabulates it for chance 1/2"};
  return critical;
}

bool rejects(const CriticalNumber& critical, long correct) {
  return (critical.at_least && correct >= *critical.at_least) ||
         (critical.at_most && correct <= *critical.at_most);
}

}  // namespace palpate::analysis
