#pragma once

#include <optional>

#include "analysis/detection/dprime.hpp"
#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

/// Answers of a two-interval task by the interval that held the correct condition.
struct OrderCounts {
  long correct_first = 0, trials_first = 0;    // it came first
  long correct_second = 0, trials_second = 0;  // it came second
};

struct IntervalBias {
  OrderCounts counts{};
  double hit_rate_first = 0.0, hit_rate_second = 0.0;  // NaN for an order that never came
  Interval interval_first{}, interval_second{};        // Clopper-Pearson
  long answers_first = 0;                              // answers "1", right or wrong
  long answers = 0;
  double share_first = 0.0;
  Interval share_interval{};               // Clopper-Pearson
  PValues p{};                             // of the share against 1/2
  std::optional<DPrimeByOrder> d_prime{};  // both orders needed
  Method method{};
};

/// Whether one interval is preferred. With an order drawn by fair coins, "1" is the answer in half of all
/// trials unless an interval is favoured, whatever the sensitivity: an exact binomial test of the number of
/// such answers. Throws std::invalid_argument for counts that cannot be or no trial at all.
IntervalBias interval_bias(const OrderCounts& counts, DPrimeCorrection correction, double level = 0.95);

}  // namespace palpate::analysis
