#pragma once

#include <optional>

#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

/// The results of n trials at which the exact binomial test rejects chance.
struct CriticalNumber {
  long trials = 0;
  double chance = 0.5;
  double alpha = 0.05;
  Side side = Side::Greater;
  std::optional<long> at_least{};  // reject from this many correct answers on; empty: no number is enough
  std::optional<long> at_most{};   // reject up to this many; empty: none
  double size = 0.0;               // the probability of a rejection at chance, <= alpha
  Method method{};
};

/// Greater: the smallest k with P(X >= k) <= alpha. Less: the largest k with P(X <= k) <= alpha. Two-sided:
/// the k whose minlike p value (see binomial_test) is <= alpha: a lower and an upper tail. Probabilities that
/// exceed alpha by less than 1 part in 1e12 count as equal to it, so that alpha = 1/32 means what it says.
/// Throws std::invalid_argument unless trials >= 1, 0 < chance < 1, 0 < alpha < 1.
CriticalNumber critical_number(long trials, double chance, double alpha, Side side);

/// Whether `correct` lies in the region of rejection.
bool rejects(const CriticalNumber& critical, long correct);

}  // namespace palpate::analysis
