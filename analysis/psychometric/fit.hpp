#pragma once

#include <span>
#include <vector>

#include "analysis/psychometric/design.hpp"
#include "analysis/psychometric/likelihood.hpp"
#include "analysis/psychometric/start_grid.hpp"

namespace palpate::analysis {

/// Whether the likelihood has a maximum, and else where its supremum is.
enum class FitKind {
  Found,  // at a function of the family
  Step,   // at an infinite slope: the answers are separable
  Flat    // at a slope of zero: the answers do not rise with the level
};

/// The function of greatest likelihood, eta = beta (u - alpha).
struct PsychometricFit {
  FitKind kind = FitKind::Found;
  double alpha = 0.0;                         // [u]; the middle of the gap for a step, NaN where flat
  double beta = 0.0;                          // [1/u]; infinite for a step, 0 where flat
  double lapse = 0.0;                         // NaN where flat
  double log_likelihood = 0.0;                // without the binomial coefficients
  double step_lower = 0.0, step_upper = 0.0;  // [u]: a step stands anywhere between; equal: at a level
  double probability = 0.0;                   // at that level; everywhere where flat
  Line line{};                                // the same on the design's scale, where found
};

/// The greatest of the local maxima that Newton's method reaches from the summits of a grid of functions
/// (StartGrid, climb), compared with both limits. For many sets of answers at the same levels.
class Fitter {
 public:
  explicit Fitter(Design design);
  PsychometricFit fit(std::span<const double> correct) const;
  const Design& design() const { return design_; }

 private:
  Design design_;
  StartGrid grid_;
};

/// The same fit with its places on the scale of `design`, which is the fitted one, placed() elsewhere.
PsychometricFit placed(PsychometricFit fit, const Design& design, const Placement& on);

PsychometricFit fit_psychometric(const Design& design, std::span<const double> correct);

/// psi at each row of the design.
std::vector<double> fitted_psi(const Design& design, const PsychometricFit& fit);

/// u at which F = p; for a step the step's place, NaN where flat.
double place_at(const PsychometricFit& fit, Shape shape, double p);

/// The fit's function with eta = beta (u - alpha) on the design's scale.
Line line_of(const Design& design, double alpha, double beta, double lapse);

}  // namespace palpate::analysis
