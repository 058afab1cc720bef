#pragma once

#include <vector>

#include "sim/cost/cycle_cost.hpp"
#include "sim/model/model.hpp"

namespace palpate::sim {

/// What the cycles of one variant take [us].
struct VariantTime {
  std::vector<double> rounds{};  // medians of each round: how far two measurements may differ
  Percentiles warm{};            // over all rounds
  double first = 0.0;            // of a fresh simulation's first cycle, at the deepest pose: median of some
};

/// Presses to and fro in rounds, over the poses at which bodies touch. @param seconds  about so long, of at least three rounds
VariantTime measure_time(const Model& model, double depth, double seconds);

}  // namespace palpate::sim
