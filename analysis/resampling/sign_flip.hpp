#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

struct SignFlipOptions {
  double level = 0.95;
  long resamples = 99'999;  // of the Monte Carlo ways, where exactness is out of reach
  std::uint64_t seed = 20030901;
};

struct SignFlipTest {
  std::size_t n = 0;  // differences, zeros included
  double mean = 0.0;  // of the differences: the estimate
  PValues p{};
  bool exact = true;                    // false: Monte Carlo, p = (1 + as extreme)/(1 + resamples)
  long resamples = 0;                   // 0 when exact
  std::optional<std::uint64_t> seed{};  // of the Monte Carlo part, if there was one
  Interval interval{};  // for the mean, by inverting the test; ends may be infinite when n is small
  Method method{};
};

/// Permutation test on paired differences: if a and b are exchangeable within each pair, each difference has
/// either sign with probability 1/2. The statistic is the sum. Exact for up to 20 differences, and for more
/// that are whole steps of a common unit (1 down to 1/240) as long as n times the sum of all steps is below
/// 5e7; else a seeded Monte Carlo with the add-one rule [PhipsonSmyth2010], of fewer resamples than asked
/// where n times resamples exceeds 5e7 (the result says how many). Sums that agree to 1e-9 of the sum of
/// magnitudes count as equal. The interval holds the shifts that the test does not reject: order statistics
/// of the means of all subsets [Hartigan1969] (n <= 20), or of a seeded sample of them. Throws
/// std::invalid_argument for no differences, one that is not finite, or resamples < 999.
SignFlipTest sign_flip_test(std::span<const double> differences, const SignFlipOptions& options = {});

}  // namespace palpate::analysis
