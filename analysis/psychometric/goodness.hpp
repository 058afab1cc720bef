#pragma once

#include <span>
#include <vector>

#include "analysis/psychometric/fit.hpp"

namespace palpate::analysis {

/// Twice the log likelihood that a function of its own for each block has above the fit's.
/// Source: [WichmannHill2001a] eq. 6.
double deviance_of(const Design& design, std::span<const double> correct, double log_likelihood);

/// The same against a proportion for each distinct level: blocks at one level count as one.
double pooled_deviance_of(const Design& design, std::span<const double> correct, double log_likelihood);

/// How a block agrees with the fit, and what the fit would be without it.
struct BlockInfluence {
  double psi = 0.0;       // fitted
  double residual = 0.0;  // deviance residual: signed square root of the block's part of the deviance
  FitKind without = FitKind::Found;
  double threshold_change = 0.0;  // [x] threshold without the block less that with it; NaN: there is none
  double slope_change = 0.0;      // [1/x], of dF/dx; infinite or NaN where the fit without is no function
};

/// In the order of the blocks. NaN changes, too, where the levels left are too few. Source:
/// [WichmannHill2001a], section on influential observations.
std::vector<BlockInfluence> block_influence(std::span<const Block> blocks, const PsychometricModel& model,
                                            const PsychometricFit& fit);

}  // namespace palpate::analysis
