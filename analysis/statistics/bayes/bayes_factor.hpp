#pragma once

#include <string_view>

#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

/// What is believed about the proportion correct if it is not chance: a beta distribution, cut off at chance
/// for a one-sided alternative. Beta(1, 1) takes every proportion for equally likely.
struct BetaPrior {
  double a = 1.0, b = 1.0;  // > 0
};

struct BayesFactor {
  long correct = 0, trials = 0;
  double chance = 0.5;
  Side side = Side::Greater;
  BetaPrior prior{};
  double log_bayes_factor = 0.0;  // ln of the next; -infinity where that is below the smallest number
  double bayes_factor = 1.0;      // P(data | not chance)/P(data | chance), "BF10"
  double posterior_median = 0.0;  // of the proportion, if it is not chance; NaN where it can't be told
  Interval interval{};            // credible, equal-tailed, for the same
  Method method{};
};

/// Bayes factor of "the proportion correct lies above (below, off) chance" against "it is chance".
/// Greater and less cut the prior off at chance and scale it to 1. The binomial's likelihood is integrated
/// over the prior in closed form. Sources: [Jeffreys1961] section 5.1, [KassRaftery1995]. Throws
/// std::invalid_argument for counts, chance, level or a prior that cannot be.
BayesFactor bayes_factor(long correct, long trials, double chance, Side side, const BetaPrior& prior,
                         double level = 0.95);

/// Kass & Raftery's words (1995, section 3.2) for a factor or its reciprocal: "positive evidence for chance".
std::string evidence_in_words(double log_bayes_factor);

}  // namespace palpate::analysis
