#include "analysis/mixed/glmm.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/mixed/climb.hpp"

namespace palpate::analysis {
namespace {

// From a root of the covariance: its rows are the effects in terms of independent ones.
RandomSpread spread_of(const Eigen::Matrix2d& root, RandomEffects random) {
  RandomSpread spread{.intercept = root.row(0).norm()};
  if (random == RandomEffects::Intercept) return spread;
  spread.slope = root.row(1).norm();
  if (spread.intercept > 0 && *spread.slope > 0) {
    const double cosine = root.row(0).normalized().dot(root.row(1).normalized());
    spread.correlation = std::clamp(cosine, -1.0, 1.0);
  }
  return spread;
}

template <int Q>
GlmmFit fit(const Observations& data, const GlmmOptions& options) {
  Climb<Q> climb(data, options);
  climb.run();
  const auto& at = climb.at();
  Eigen::Matrix2d lambda = Eigen::Matrix2d::Zero();
  lambda(0, 0) = at[2];
  if constexpr (Q == 2) lambda(1, 0) = at[3], lambda(1, 1) = at[4];
  Eigen::Matrix2d unit;  // from the standardised level to the level's own unit
  unit << 1, -data.centre / data.scale, 0, 1 / data.scale;
  GlmmFit result{.options = options};
  result.standardised = {.covariance = climb.fixed_covariance(),
                         .fixed = at.template head<2>(),
                         .centre = data.centre,
                         .scale = data.scale};
  result.fixed = unit * at.template head<2>();
  result.covariance = unit * climb.fixed_covariance() * unit.transpose();
  const Eigen::Matrix2d root = unit * lambda;
  result.random_covariance = root * root.transpose();
  result.spread = spread_of(root, options.random);
  result.log_likelihood = climb.log_likelihood() + data.log_ways;
  result.parameters = Climb<Q>::kParameters - (options.with_slope ? 0 : 1);
  result.singular = climb.singular();
  result.convergence = climb.convergence();
  return result;
}

}  // namespace

GlmmFit fit_glmm(const Observations& data, const GlmmOptions& options) {
  const int most = options.random == RandomEffects::Intercept ? 50 : 25;
  if (options.nodes < 1 || options.nodes > most) {
    throw std::invalid_argument(fmt::format("nodes is {}; accepted: 1 (Laplace) to {}", options.nodes, most));
  }
  return options.random == RandomEffects::Intercept ? fit<1>(data, options) : fit<2>(data, options);
}

}  // namespace palpate::analysis
