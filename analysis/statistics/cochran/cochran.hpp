#pragma once

#include <optional>
#include <vector>

#include "analysis/numerics/result.hpp"
#include "analysis/resampling/bootstrap.hpp"

namespace palpate::analysis {

struct CochranTest {
  std::size_t n = 0;            // rows: examinees, or trials that were repeated under every column
  std::size_t informative = 0;  // rows with both 0 and 1: all that the test looks at
  std::vector<double> proportions{};
  std::vector<Interval> intervals{};  // for them, Clopper-Pearson
  double q = 0.0;
  long degrees_of_freedom = 0;
  double p_asymptotic = 1.0;
  std::optional<double> p_exact{};  // over all orders within rows; empty where they are too many
  double eta_squared = 0.0;         // Q/(n(k - 1)), 0 to 1
  Interval eta_squared_interval{};
  Method method{};
};

/// Cochran's Q: whether k >= 2 proportions of the same n rows are equal. `columns` holds the things compared,
/// each with 0 or 1 for each row. For two columns Q is McNemar's chi-squared without correction, and the
/// exact p value McNemar's exact one. Without rows that hold both answers Q is 0 and p is 1. The percentile
/// bootstrap interval of the effect size never reaches 0 and lies too high where it is small. Sources:
/// [Cochran1950], effect size [Serlin1982]. Throws std::invalid_argument for other values, fewer columns or
/// no rows.
CochranTest cochran_test(const std::vector<std::vector<double>>& columns,
                         const BootstrapOptions& options = {});

}  // namespace palpate::analysis
