#pragma once

#include <span>

#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

struct PairedTTest {
  std::size_t n = 0;  // differences
  double mean = 0.0, standard_deviation = 0.0;
  double t = 0.0;
  long degrees_of_freedom = 0;
  PValues p{};
  Interval interval{};     // for the mean
  double cohen_dz = 0.0;   // mean/standard deviation of the differences
  Interval dz_interval{};  // from the noncentral t distribution; both ends NaN beyond |t| = 1e4
  Method method{};
};

/// Student's t-test that the mean of paired differences is 0. The effect size is Cohen's d_z; its interval
/// holds the d_z for which t lies within the two tails of the noncentral t distribution with noncentrality
/// d_z sqrt(n). Sources: [Student1908], [CummingFinch2001]. Throws std::invalid_argument for fewer than 2
/// differences, one that is not finite, or differences that are all equal, or equal but for
/// rounding (settled_differences()).
PairedTTest paired_t_test(std::span<const double> differences, double level = 0.95);

}  // namespace palpate::analysis
