#include "analysis/mixed/population.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/numerics/infinity.hpp"
#include "analysis/numerics/standard_normal.hpp"

namespace palpate::analysis {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Coefficient coefficient(double estimate, double variance, double level) {
  Coefficient result{.estimate = estimate, .standard_error = std::sqrt(variance)};
  result.z = estimate / result.standard_error;
  result.p = std::erfc(std::abs(result.z) / std::numbers::sqrt2);
  const double half = critical_z(level) * result.standard_error;
  result.interval = {.lower = estimate - half, .upper = estimate + half, .level = level, .method = "Wald"};
  return result;
}

Interval fieller(double lower, double upper, double level) {
  return {.lower = lower, .upper = upper, .level = level, .method = "Fieller"};
}

// The levels x at which b0 + b1 x is within z standard errors of 0, found over the standardised level.
LevelEstimate pse_of(const StandardisedEffects& effects, double level) {
  const double b0 = effects.fixed[0], b1 = effects.fixed[1], z = critical_z(level);
  const Eigen::Matrix2d& v = effects.covariance;
  const auto of_level = [&](double x) { return effects.centre + effects.scale * x; };
  LevelEstimate pse{.estimate = of_level(-b0 / b1)};
  const Eigen::Vector2d slopes(-1 / b1, b0 / (b1 * b1));
  pse.standard_error = effects.scale * std::sqrt(slopes.dot(v * slopes));
  const double a = b1 * b1 - z * z * v(1, 1), b = b0 * b1 - z * z * v(0, 1), c = b0 * b0 - z * z * v(0, 0);
  if (std::isnan(a)) {
    pse.interval = fieller(kNaN, kNaN, level);
  } else if (a <= 0) {
    pse.interval = fieller(-kInfinity, kInfinity, level);
  } else {
    const double root =
        std::sqrt(std::max(0.0, b * b - a * c));  // not below 0 where a > 0, but for round-off
    pse.interval = fieller(of_level((-b - root) / a), of_level((-b + root) / a), level);
  }
  return pse;
}

LevelEstimate jnd_of(const GlmmFit& fit, const Coefficient& slope, double level) {
  const double distance = quantile_of(fit.options.link, 0.75);
  LevelEstimate jnd{.estimate = distance / std::abs(slope.estimate)};
  jnd.standard_error = jnd.estimate * slope.standard_error / std::abs(slope.estimate);
  const double half = slope.interval.upper - slope.estimate;
  const double least = std::abs(slope.estimate) - half, most = std::abs(slope.estimate) + half;
  jnd.interval = fieller(distance / most, least <= 0 ? kInfinity : distance / least, level);
  if (std::isnan(half)) jnd.interval = fieller(kNaN, kNaN, level);
  return jnd;
}

LikelihoodRatio slope_test(const Observations& data, const GlmmFit& full) {
  GlmmOptions options = full.options;
  options.with_slope = false;
  const GlmmFit flat = fit_glmm(data, options);
  LikelihoodRatio test{.chi_squared = std::max(0.0, 2 * (full.log_likelihood - flat.log_likelihood))};
  test.p = cdf(complement(boost::math::chi_squared(test.degrees_of_freedom), test.chi_squared));
  test.converged = full.convergence.converged && flat.convergence.converged;
  return test;
}

Method method_of(const GlmmOptions& options) {
  const std::string integral =
      options.nodes == 1 ? "Laplace approximation"
                         : fmt::format("adaptive Gauss-Hermite quadrature, {} nodes", options.nodes);
  return {.name = fmt::format("generalised linear mixed model, {} link, random {}; {}", name_of(options.link),
                              options.random == RandomEffects::Slope ? "intercept and slope" : "intercept",
                              integral),
          .source = "Pinheiro & Bates 1995; Moscatelli et al. 2012; Fieller 1954"};
}

}  // namespace

GlmmAnalysis glmm_analysis(const std::vector<LevelAnswers>& answers, const GlmmOptions& options,
                           double level) {
  require_level(level, "confidence level");
  const Observations data = observations(answers);
  GlmmAnalysis result{.examinees = data.examinees(),
                      .rows = data.rows,
                      .trials = data.total_trials,
                      .method = method_of(options)};
  GlmmOptions full = options;
  full.with_slope = true;
  result.fit = fit_glmm(data, full);
  result.intercept = coefficient(result.fit.fixed[0], result.fit.covariance(0, 0), level);
  result.slope = coefficient(result.fit.fixed[1], result.fit.covariance(1, 1), level);
  result.slope_test = slope_test(data, result.fit);
  result.pse = pse_of(result.fit.standardised, level);
  result.jnd = jnd_of(result.fit, result.slope, level);
  return result;
}

}  // namespace palpate::analysis
