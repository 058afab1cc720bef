#pragma once

#include <span>
#include <vector>

#include "analysis/statistics/beta_binomial/beta_binomial.hpp"

namespace palpate::analysis {

/// The likelihood of a beta-binomial model over its two parameters, its maximum and its profiles. The
/// parameters live in the closed unit square; the maximum may lie on its edge.
class BetaBinomialFit {
 public:
  /// chance 0: the plain model.
  BetaBinomialFit(std::span<const ExamineeCount> counts, double chance);

  double log_likelihood(double mean, double gamma) const;
  double log_likelihood() const { return best_; }  // at the maximum
  double mean() const { return mean_; }
  double profile_of_mean(double mean) const;    // the best over gamma
  double profile_of_gamma(double gamma) const;  // the best over the mean
  BoundedEstimate mean_estimate(double level) const;
  BoundedEstimate gamma_estimate(double level) const;

 private:
  struct Repeated {
    ExamineeCount count{};
    double times = 0.0;
  };
  double chance_;
  double log_ways_ = 0.0;
  std::vector<Repeated> counts_{};  // equal counts once
  double mean_ = 0.0, gamma_ = 0.0, best_ = 0.0;
};

}  // namespace palpate::analysis
