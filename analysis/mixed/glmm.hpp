#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>

#include "analysis/mixed/link.hpp"
#include "analysis/mixed/observations.hpp"

namespace palpate::analysis {

/// What differs between examinees: the intercept, or intercept and slope together, correlated.
enum class RandomEffects { Intercept, Slope };

struct GlmmOptions {
  Link link = Link::Probit;
  RandomEffects random = RandomEffects::Intercept;
  int nodes = 1;           // of the quadrature for each random effect; 1: Laplace's approximation
  bool with_slope = true;  // false: the fixed slope is held at 0, for a likelihood-ratio test
};

struct Convergence {
  bool converged = false;
  std::string reason{};  // what it was judged by, or what is wrong
  int evaluations = 0;   // of the likelihood with its gradient
  double remaining =
      std::numeric_limits<double>::quiet_NaN();  // log-likelihood that a last Newton step gained
};

/// How examinees differ, in the unit of the level. Absent where the model has no random slope, or where a
/// standard deviation of 0 leaves the correlation open.
struct RandomSpread {
  double intercept = 0.0;               // standard deviation
  std::optional<double> slope{};        // standard deviation
  std::optional<double> correlation{};  // of the two
};

/// The fixed effects over the standardised level (level - centre)/scale: where the level's origin lies far
/// from the levels, those over the level itself are differences of large numbers.
struct StandardisedEffects {
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  Eigen::Vector2d fixed{0, 0};
  double centre = 0.0, scale = 1.0;
};

/// A fit of link(P(answer is 1)) = (b0 + e0) + (b1 + e1) level, e normal between examinees.
struct GlmmFit {
  GlmmOptions options{};
  Eigen::Vector2d fixed{0, 0};                                  // b0, b1
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();         // of them; NaN where it did not converge
  Eigen::Matrix2d random_covariance = Eigen::Matrix2d::Zero();  // of e
  StandardisedEffects standardised{};
  RandomSpread spread{};
  double log_likelihood = 0.0;  // of the rows as given, binomial coefficients included
  int parameters = 0;
  bool singular =
      false;  // a variance of 0 or a correlation of 1 or -1 is the estimate: an end of what can be
  Convergence convergence{};
};

/// Maximum likelihood, the random effects integrated out by adaptive Gauss-Hermite quadrature
/// [PinheiroBates1995] about the mode, scaled by the observed curvature; a product rule for two effects. One
/// node is Laplace's approximation with the observed curvature (for the probit link lme4 takes the expected
/// one, which differs a little). The covariance is the inverse of the observed information of all parameters
/// together. Parameters are maximised without bounds, for the likelihood is symmetric in the signs of
/// Lambda's columns. Throws std::invalid_argument for nodes outside 1..50 (25 for two effects).
GlmmFit fit_glmm(const Observations& data, const GlmmOptions& options);

}  // namespace palpate::analysis
