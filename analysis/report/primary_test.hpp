#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/binomial/binomial_test.hpp"
#include "analysis/report/study_table.hpp"
#include "analysis/statistics/looks/planned_looks.hpp"
#include "analysis/statistics/randomisation/order_randomisation.hpp"

namespace palpate::analysis {

/// Which of the looks that the protocol plans a report is.
struct LookTaken {
  int number = 1, of = 1;  // the second of three
  double spent = 0.0;      // alpha that may have been spent by now
};

/// The test that the protocol names, on one cell: is the number of correct answers that of guessing?
struct PrimaryTest {
  std::string name{};  // "paired-comparison", "order-randomisation"
  long correct = 0, trials = 0;
  double chance = 0.5, proportion = 0.0;
  Side side = Side::Greater;
  PValues p{};
  CriticalNumber critical{};  // region of rejection
  double size = 0.0;          // probability that guessing is rejected here or at a planned look before
  std::vector<double> under_guessing{};  // probability of 0, 1, ... trials correct answers
  Interval interval{};                   // for the proportion, two-sided
  Interval bound{};                      // the one that belongs to `side`
  Interval wilson{};
  std::optional<LookTaken> look{};  // where the protocol plans looks
  Method method{};
};

/// Which planned look `complete` examinees are; empty where the protocol plans none or none is due.
std::optional<LookTaken> look_due(const StudyDesign& design, long complete);

/// @param sittings  counts of each sitting in the cell; together they are the cell
/// @param look      at a planned look, the region of rejection is that of the alpha spent so far; looks
/// before
///                  it are taken to have been at the numbers of answers that were planned
PrimaryTest primary_test(const StudyDesign& design, std::span<const OrderStratum> sittings, double level,
                         const std::optional<LookTaken>& look);

}  // namespace palpate::analysis
