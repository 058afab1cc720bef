#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/numerics/result.hpp"
#include "analysis/psychometric/design.hpp"

namespace palpate::analysis {

/// What is known of one parameter after the data.
struct Posterior {
  double mean = 0.0;
  double mode = 0.0;    // its value where the joint posterior density is greatest
  Interval interval{};  // equal-tailed credible interval
};

/// psi(x) = guess + (1 - guess - lapse) F(x), the proportion correct of a block varying about psi with a beta
/// distribution of standard deviation eta sqrt(psi (1 - psi)): answers within a block hang together.
struct BayesianFit {
  Posterior threshold{};             // level x at which F = 0.5
  Posterior width{};                 // between F = 0.05 and F = 0.95, on the scale u
  Posterior lapse{};                 //
  std::optional<Posterior> guess{};  // where it is free
  Posterior eta{};                   // 0: binomial; towards 1: all of a block's answers alike
  std::vector<std::string> priors{};
  long grid = 0;  // functions whose posterior was added up
  Method method{};
};

/// Posterior over a grid with the priors and the beta-binomial model of [Schuett2016] (psignifit 4), which
/// bind sparse data: thresholds and widths that the levels could not show are unlikely beforehand. The grid
/// covers the priors, is narrowed twice to where the marginal posteriors are above 1e-4 of their greatest
/// value, and its cells are weighted by the trapezoidal rule; the mode is refined from the best cell. Guess
/// and lapse rates have beta(1, 10) priors up to 0.5, eta a beta(1, 10) prior; without a value for `guess` it
/// is free, for yes-no tasks. Throws std::invalid_argument for fewer than two distinct levels, a Weibull
/// level <= 0, or a guess rate outside [0, 1).
BayesianFit bayesian_psychometric(std::span<const Block> blocks, Shape shape, std::optional<double> guess,
                                  double level);

/// Log of the beta-binomial probability of k of n without the binomial coefficient; eta = 0 is the binomial.
double log_beta_binomial(double k, double n, double psi, double eta);

}  // namespace palpate::analysis
