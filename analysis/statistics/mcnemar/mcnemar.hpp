#pragma once

#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

/// The same trials answered twice: rows the first answer, columns the second, "correct" before "wrong".
struct PairedTable {
  long both = 0;         // a
  long first_only = 0;   // b
  long second_only = 0;  // c
  long neither = 0;      // d
};

struct McNemarTest {
  PairedTable table{};
  long pairs = 0;                  // a + b + c + d
  long discordant = 0;             // b + c: all that the test looks at
  double difference = 0.0;         // of the two proportions, (b - c)/n
  Interval difference_interval{};  // Wald; a large-sample interval
  double odds_ratio = 0.0;         // conditional, b/c; infinite when c = 0 < b, NaN when both are 0
  Interval odds_ratio_interval{};  // exact, from Clopper-Pearson; 0 to infinity without discordant pairs
  PValues exact{};           // binomial on the discordant pairs; greater: the first is correct more often
  PValues mid_p{};           // the same with half of what is as likely as the outcome seen
  double chi_squared = 0.0;  // (b - c)^2/(b + c), 1 degree of freedom
  double chi_squared_corrected = 0.0;  // (|b - c| - 1)^2/(b + c), with continuity correction
  double p_asymptotic = 1.0;           // two-sided
  double p_asymptotic_corrected = 1.0;
  Method method{};
};

/// McNemar's test of equal marginal proportions. Sources: [McNemar1947]; exact and mid-p as in
/// [Fagerland2013]. It asks for trials that are paired by design; two models tried by one examinee on
/// separate trials are not. Throws std::invalid_argument for negative counts or an empty table.
McNemarTest mcnemar_test(const PairedTable& table, double level = 0.95);

}  // namespace palpate::analysis
