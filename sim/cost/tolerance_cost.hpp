#pragma once

#include <span>
#include <vector>

#include "sim/cost/cycle_cost.hpp"
#include "sim/model/model.hpp"

namespace palpate::sim {

/// What a cycle takes, and how far its force can be off, where the law may stop early.
struct ToleranceCost {
  double tolerance = 0.0;      // contact.tolerance, of the force [-]; 0: solved to the end
  Percentiles total{};         // of the whole cycle
  double median_bound = 0.0;   // of the force's error, of the largest force on a probe in the same cycle [-]
  double largest_bound = 0.0;  // likewise
  int cycles = 0;              // that were timed
  int ended_early = 0;         // of them, within the tolerance
};

/// Times the poses of measure_cycle() under each tolerance. The tolerances take turns, a press to and fro each,
/// so that what else the machine does falls on all alike; the first turn of each warms up and is not counted.
/// @return in the order of `tolerances`; empty for a law that knows no bound, or whose bound is 0 throughout
std::vector<ToleranceCost> measure_tolerances(const Model& model, const ContactLaw& law,
                                              const CycleSampling& sampling,
                                              std::span<const double> tolerances);

}  // namespace palpate::sim
