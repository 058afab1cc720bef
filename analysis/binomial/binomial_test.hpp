#pragma once

#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

struct BinomialTest {
  long correct = 0;  // k
  long trials = 0;   // n
  double chance = 0.5;
  Side side = Side::Greater;
  double proportion = 0.0;  // k/n
  PValues p{};
  PValues mid_p{};
  Interval interval{};  // two-sided, Clopper-Pearson
  Interval bound{};     // the one that belongs to `side`: one-sided for greater and less
  Interval wilson{};
  Interval jeffreys{};
  Method method{};
};

/// Exact test that each of `trials` independent answers is correct with probability `chance`.
/// One-sided: P(X >= k) or P(X <= k). Two-sided: the sum of the probabilities of all outcomes that are no
/// more likely than the one seen ("minlike"), outcomes within 1e-7 of its probability counted as equally
/// likely, as R's binom.test does; at chance 1/2 that is twice the smaller tail. Throws std::invalid_argument
/// unless 0 <= correct <= trials, trials >= 1, 0 < chance < 1, 0 < level < 1.
BinomialTest binomial_test(long correct, long trials, double chance, Side side, double level = 0.95);

/// The p values alone.
PValues binomial_p(long correct, long trials, double chance);

/// The same with half of the probability of the outcomes that are as likely as the one seen (one-sided: of
/// the one seen): mid-p values. They are less cautious: their false positives reach alpha on the average, and
/// may exceed it a little. Source: [Lancaster1961]; at chance 1/2 as in [Fagerland2013].
PValues binomial_mid_p(long correct, long trials, double chance);

}  // namespace palpate::analysis
