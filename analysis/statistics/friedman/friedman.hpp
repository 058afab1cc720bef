#pragma once

#include <optional>
#include <vector>

#include "analysis/numerics/result.hpp"
#include "analysis/resampling/bootstrap.hpp"

namespace palpate::analysis {

struct FriedmanTest {
  std::size_t n = 0;                 // examinees
  std::vector<double> mean_ranks{};  // of each column; the smallest value of an examinee has rank 1
  bool ties = false;
  double chi_squared = 0.0;  // corrected for ties
  long degrees_of_freedom = 0;
  double p_asymptotic = 1.0;
  std::optional<double> p_exact{};  // over all orders within examinees; empty where they are too many
  double kendall_w = 0.0;           // agreement, 0 to 1; NaN where every examinee ties everything
  Interval w_interval{};
  Method method{};
};

/// Friedman's rank test of k >= 2 things that each of n >= 2 examinees judged: within each examinee every
/// order is equally likely. Values that are equal but for rounding are ties (settled_values()). `columns` holds the things, each with a value for each examinee. With nothing but
/// ties p is 1. Kendall's W = chi^2/(n(k - 1)); its percentile bootstrap interval never reaches 0 and lies
/// too high where W is small. Sources: [Friedman1937], ties as in [Conover1999] section 5.8,
/// [KendallBabingtonSmith1939]. Throws std::invalid_argument for fewer columns or rows, columns of different
/// lengths or values that are not finite.
FriedmanTest friedman_test(const std::vector<std::vector<double>>& columns,
                           const BootstrapOptions& options = {});

}  // namespace palpate::analysis
