#include "analysis/psychometric/fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/numerics/infinity.hpp"
#include "analysis/psychometric/climb.hpp"
#include "analysis/psychometric/limits.hpp"

namespace palpate::analysis {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kSame = 1e-7;  // likelihoods that differ by less cannot be told apart on the way to a limit

PsychometricFit flat_fit(const FlatLimit& flat) {
  return {.kind = FitKind::Flat,
          .alpha = kNone,
          .beta = 0.0,
          .lapse = kNone,
          .log_likelihood = flat.log_likelihood,
          .probability = flat.probability};
}

PsychometricFit step_fit(const StepLimit& step) {
  return {.kind = FitKind::Step,
          .alpha = 0.5 * (step.lower + step.upper),
          .beta = kInfinity,
          .lapse = step.lapse,
          .log_likelihood = step.log_likelihood,
          .step_lower = step.lower,
          .step_upper = step.upper,
          .probability = step.probability};
}

double middle_of(const Design& design, const Line& line) {
  return design.centre - line.intercept / line.rise * design.half_range;
}

PsychometricFit judged(const Design& design, std::span<const double> correct, const Summit& best) {
  const StepLimit step = best_step(design, correct);
  const FlatLimit flat = best_flat(design, correct);
  const double beyond_flat = std::max(best.log_likelihood, step.log_likelihood);
  if (flat.log_likelihood >= beyond_flat - kSame) return flat_fit(flat);
  if (step.log_likelihood >= best.log_likelihood - kSame) return step_fit(step);
  return {.kind = FitKind::Found,
          .alpha = middle_of(design, best.line),
          .beta = best.line.rise / design.half_range,
          .lapse = best.line.lapse,
          .log_likelihood = best.log_likelihood,
          .line = best.line};
}

}  // namespace

Fitter::Fitter(Design design) : design_(std::move(design)), grid_(design_) {}

PsychometricFit Fitter::fit(std::span<const double> correct) const {
  Summit best{.log_likelihood = -kInfinity};
  for (const Line& start : grid_.starts(correct)) {
    const Summit other = climb(design_, correct, start, &best);
    if (other.log_likelihood > best.log_likelihood) best = other;
  }
  return judged(design_, correct, best);
}

PsychometricFit placed(PsychometricFit fit, const Design& design, const Placement& on) {
  fit.alpha = fit.kind == FitKind::Found ? middle_of(design, fit.line) : on.from(fit.alpha);
  fit.beta *= on.unit;
  fit.step_lower = on.from(fit.step_lower);
  fit.step_upper = on.from(fit.step_upper);
  return fit;
}

PsychometricFit fit_psychometric(const Design& design, std::span<const double> correct) {
  return Fitter(design).fit(correct);
}

std::vector<double> fitted_psi(const Design& design, const PsychometricFit& fit) {
  const PsychometricModel& model = design.model;
  std::vector<double> psi;
  for (std::size_t row = 0; row < design.v.size(); ++row) {
    if (fit.kind == FitKind::Flat) {
      psi.push_back(fit.probability);
    } else if (fit.kind == FitKind::Step) {
      const double place = design.place[row];
      const bool on_step = fit.step_lower == fit.step_upper && place == fit.step_lower;
      psi.push_back(on_step ? fit.probability : place <= fit.step_lower ? model.guess : 1 - fit.lapse);
    } else {
      const double eta = fit.line.intercept + fit.line.rise * design.v[row];
      psi.push_back(model.guess + (1 - model.guess - fit.lapse) * shape_at(model.shape, eta).below);
    }
  }
  return psi;
}

double place_at(const PsychometricFit& fit, Shape shape, double p) {
  if (fit.kind == FitKind::Found) return fit.alpha + shape_quantile(shape, p) / fit.beta;
  return fit.alpha;
}

Line line_of(const Design& design, double alpha, double beta, double lapse) {
  const double rise = beta * design.half_range;
  return {.intercept = beta * (design.centre - alpha), .rise = rise, .lapse = lapse};
}

}  // namespace palpate::analysis
