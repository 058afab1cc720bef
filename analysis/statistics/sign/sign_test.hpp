#pragma once

#include <span>

#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

struct SignTest {
  std::size_t n = 0;  // differences given
  long positive = 0, negative = 0, zeros = 0;
  PValues p{};
  double share_positive = 0.5;  // positive/(positive + negative), the effect size; NaN where all are zero
  Interval share_interval{};    // for it, Clopper-Pearson; 0 to 1 where all are zero
  double median = 0.0;          // of the differences
  Interval interval{};          // for it, by order statistics; ends may be infinite when n is small
  Method method{};
};

/// Exact sign test: of the differences that are not zero, half are positive. Zeros are left out of the test
/// and kept in the median and its interval. With nothing but zeros p is 1. Throws std::invalid_argument for
/// no differences or one that is not finite. Differences of 0 but for rounding are zeros
/// (settled_differences()). Source: [Conover1999].
SignTest sign_test(std::span<const double> given, double level = 0.95);

/// The same from counts: there is then no median, and its interval is empty (both ends NaN).
SignTest sign_test_of_counts(long positive, long negative, double level = 0.95);

}  // namespace palpate::analysis
