#pragma once

#include <vector>

#include "analysis/mixed/glmm.hpp"
#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

/// A coefficient with Wald's test of 0 and Wald's interval. NaN but for the estimate where the fit did not
/// converge.
struct Coefficient {
  double estimate = 0.0;
  double standard_error = 0.0;
  double z = 0.0;
  double p = 1.0;  // two-sided
  Interval interval{};
};

/// A level of the psychometric function, in the unit of the level.
struct LevelEstimate {
  double estimate = 0.0;
  double standard_error = 0.0;  // delta method
  Interval interval{};          // Fieller's; open where the slope may be 0
};

struct LikelihoodRatio {
  double chi_squared = 0.0;
  int degrees_of_freedom = 1;
  double p = 1.0;
  bool converged = true;  // both fits
};

/// The psychometric function of the population: of an examinee whose random effects are 0.
struct GlmmAnalysis {
  std::size_t examinees = 0;
  std::size_t rows = 0;
  long trials = 0;
  GlmmFit fit{};
  Coefficient intercept{}, slope{};  // on the link's scale; the slope per unit of the level
  LikelihoodRatio slope_test{};      // of a fixed slope of 0, random effects as in the fit
  LevelEstimate pse{};               // level at which either answer is as likely: -b0/b1
  LevelEstimate jnd{};               // from there to 75 %: z(0.75)/|b1|
  Method method{};
};

/// The mixed-model psychometric function [Moscatelli2012]. Standard errors of PSE and JND are by the delta
/// method; their intervals are by Fieller's theorem [Fieller1954], which needs no symmetric distribution of a
/// ratio: both ends are infinite where the slope's own Wald interval holds 0. Throws std::invalid_argument as
/// observations() and fit_glmm() do. options.with_slope is not looked at.
GlmmAnalysis glmm_analysis(const std::vector<LevelAnswers>& answers, const GlmmOptions& options,
                           double level = 0.95);

}  // namespace palpate::analysis
