#pragma once

#include <span>
#include <vector>

#include "analysis/psychometric/likelihood.hpp"

namespace palpate::analysis {

/// Log likelihoods over a grid of functions, tabled once for a design, so that a set of answers costs a sum
/// of products and no logarithm. Where guess > 0 or the lapse rate is free the likelihood may have several
/// local maxima: the grid says from where to climb.
class StartGrid {
 public:
  explicit StartGrid(const Design& design);

  /// The grid's local maxima in threshold and slope, each at its best lapse rate, best first, at most four.
  std::vector<Line> starts(std::span<const double> correct) const;

 private:
  Line line(std::size_t cell, double lapse) const;

  std::vector<double> middles_{};  // v at eta = 0
  std::vector<double> rises_{};
  std::size_t steep_rises_ = 0;  // the last of them
  std::vector<double> lapses_{};
  std::vector<double> trials_{};
  std::vector<double> log_hit_{};   // (row x lapse x cell): log psi
  std::vector<double> log_miss_{};  // log(1 - psi)
};

}  // namespace palpate::analysis
