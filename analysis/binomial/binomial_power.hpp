#pragma once

#include <optional>

#include "analysis/binomial/critical_number.hpp"

namespace palpate::analysis {

/// The probability that the number of correct answers falls into the region of rejection when each is correct
/// with `probability` (0 and 1 included), independently.
double rejection_probability(const CriticalNumber& critical, double probability);

/// Exact power of the binomial test of `trials` trials at `alpha` when the truth is `probability`.
double binomial_power(long trials, double chance, double probability, double alpha, Side side);

struct SampleSize {
  double chance = 0.5, probability = 0.75, alpha = 0.05, target = 0.8;
  Side side = Side::Greater;
  long step = 1;                  // sizes considered: multiples of this, e.g. the trials of one examinee
  std::optional<long> first{};    // the smallest size whose power reaches the target
  std::optional<long> lasting{};  // the smallest from which no larger size up to `searched` falls below it
  double power_at_first = 0.0;
  double power_at_lasting = 0.0;
  long searched = 0;  // the largest size looked at
  Method method{};
};

/// Exact power rises with the number of trials in a sawtooth, so that a larger study may have less power than
/// a smaller one: both ends of that are given. Sizes up to `largest` are searched; where the target is not
/// reached, `first` is empty. Throws std::invalid_argument unless the numbers are probabilities, step >= 1,
/// and `probability` lies on the side that the test looks at.
SampleSize binomial_sample_size(double chance, double probability, double alpha, Side side, double target,
                                long step = 1, long largest = 2000);

}  // namespace palpate::analysis
