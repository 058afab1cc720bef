#pragma once

#include <span>
#include <vector>

#include "analysis/binomial/critical_number.hpp"

namespace palpate::analysis {

/// Two-interval answers within which the order was balanced: of `trials`, drawn in random order, exactly
/// `correct_first` had the correct condition in the first interval. One for each examinee and cell.
struct OrderStratum {
  long trials = 0;
  long correct_first = 0;  // trials whose correct interval was the first
  long answers_first = 0;  // trials answered "1"
  long correct = 0;        // trials answered correctly
};

/// Throws std::invalid_argument unless some order of some answers gives these counts.
void validate(const OrderStratum& stratum);

struct OrderRandomisationTest {
  long correct = 0, trials = 0;
  PValues p{};
  double expected = 0.0;                 // correct answers of whoever feels nothing and answers so
  double standard_deviation = 0.0;       // of them
  std::vector<double> under_guessing{};  // probability of 0, 1, ... trials correct answers
  CriticalNumber critical{};             // given the answers; chance is expected/trials
  Method method{};
};

/// Randomisation test over the admissible orders [Edgington2007]. Whoever feels nothing would have answered
/// the same whatever order had been drawn; so the answers are held fixed, and every admissible order of each
/// stratum is as likely as the one drawn. In a stratum the trials with the correct condition first that were
/// answered "1" are then hypergeometric, and the number correct follows; strata are independent, and their
/// distributions are convolved: exact. The binomial test does not hold for balanced orders: whoever answers
/// "1" as often as "2" varies more, whoever always answers "1" not at all. Two-sided: as binomial_test().
/// Throws std::invalid_argument for no strata or counts that contradict themselves.
OrderRandomisationTest order_randomisation_test(std::span<const OrderStratum> strata, double alpha,
                                                Side side);

}  // namespace palpate::analysis
