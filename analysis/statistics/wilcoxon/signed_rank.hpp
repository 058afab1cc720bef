#pragma once

#include <span>

#include "analysis/numerics/result.hpp"
#include "analysis/resampling/bootstrap.hpp"

namespace palpate::analysis {

/// What is done about differences of exactly zero.
enum class Zeros {
  Drop,  // left out before ranking [Wilcoxon1945], as R's wilcox.test does
  Pratt  // ranked with the others, then left out of the sum [Pratt1959]
};

/// "drop" or "pratt"; anything else is a std::invalid_argument.
Zeros zeros_from_name(std::string_view name);
std::string_view name_of(Zeros zeros);

struct SignedRankTest {
  std::size_t n = 0;           // differences given
  std::size_t zeros = 0;       // of them exactly zero
  bool ties = false;           // among the magnitudes of those that are not zero
  double v = 0.0;              // V: the sum of the ranks of the positive differences
  double v_max = 0.0;          // the sum of all ranks that enter
  double rank_biserial = 0.0;  // (V - V-)/(V + V-), the effect size, -1 to 1 [Kerby2014]
  PValues p{};
  bool exact = true;           // false: normal approximation with tie and continuity correction
  double pseudo_median = 0.0;  // Hodges-Lehmann estimate: the median of the means of all pairs
  Interval interval{};         // for it, from the distribution without ties; ends may be infinite
  Zeros zeros_rule = Zeros::Pratt;
  Method method{};
};

/// Wilcoxon's signed-rank test of a distribution of differences that is symmetric about zero. Equal
/// magnitudes share their mean rank, and the distribution is the exact one given these ranks (all signs
/// equally likely), up to 500 differences that are not zero; beyond that the normal approximation. The
/// interval is conservative where there are ties. Differences that are equal but for rounding are ties
/// (settled_differences()). Throws std::invalid_argument for no differences, more than 5000, or one that is
/// not finite.
SignedRankTest signed_rank_test(std::span<const double> given, Zeros zeros, double level = 0.95);

/// Percentile bootstrap interval for the rank-biserial correlation, over the differences. See
/// bootstrap_interval.
Interval rank_biserial_interval(std::span<const double> given, Zeros zeros, const BootstrapOptions& options);

}  // namespace palpate::analysis
