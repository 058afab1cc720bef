#include "analysis/statistics/psychometric/psychometric_result.hpp"

#include <fmt/core.h>

#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "analysis/numerics/log_gamma.hpp"
#include "analysis/psychometric/measures.hpp"
#include "analysis/psychometric/profile.hpp"

namespace palpate::analysis {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// The intervals of one result, by the method that was asked for.
class Intervals {
 public:
  Intervals(const PsychometricRequest& request, const Fitter& fitter, const PsychometricFit& fit,
            const std::vector<Replicate>& replicates)
      : request_(request), fitter_(fitter), fit_(fit), replicates_(replicates) {
    correct_ = correct_in(fitter.design(), request.blocks);
  }

  MeasureEstimate estimate(Measure measure, double at) const {
    return {.value = value(measure, at, fit_.alpha, fit_.beta, fit_.lapse),
            .interval = interval(measure, at)};
  }

 private:
  double value(Measure measure, double at, double alpha, double beta, double lapse) const {
    const Shape shape = request_.model.shape;
    switch (measure) {
      case Measure::Level:
        return level_at(shape, alpha, beta, at);
      case Measure::Slope:
        return slope_at(shape, alpha, beta, at);
      case Measure::HalfDistance:
        return half_distance(shape, alpha, beta);
      case Measure::Lapse:
        break;
    }
    return lapse;
  }

  Interval interval(Measure measure, double at) const {
    if (measure == Measure::Lapse && !lapse_is_free(request_.model))
      return {.lower = kNone, .upper = kNone, .level = request_.level, .method = "none: fixed"};
    if (!request_.bootstrap_intervals)
      return profile_interval(fitter_, correct_, fit_, measure, at, request_.level);
    if (replicates_.empty())
      return {.lower = kNone, .upper = kNone, .level = request_.level, .method = "none: no replicates"};
    Interval found = percentile_interval(
        replicates_, [&](const Replicate& one) { return value(measure, at, one.alpha, one.beta, one.lapse); },
        request_.level);
    found.method = fmt::format("{} bootstrap, percentile", name_of(request_.bootstrap));
    return found;
  }

  const PsychometricRequest& request_;
  const Fitter& fitter_;
  const PsychometricFit& fit_;
  const std::vector<Replicate>& replicates_;
  std::vector<double> correct_{};
};

MeasureEstimate changed(MeasureEstimate estimate, const std::function<double(double)>& change) {
  estimate.value = change(estimate.value);
  estimate.interval.lower = change(estimate.interval.lower);
  estimate.interval.upper = change(estimate.interval.upper);
  return estimate;
}

void put_discrimination(PsychometricResult& result, const Intervals& intervals) {
  const std::optional<double>& standard = result.request.standard;
  if (result.request.model.guess == 0) {
    result.pse = intervals.estimate(Measure::Level, 0.5);
    result.jnd = intervals.estimate(Measure::HalfDistance, 0.5);
  } else if (standard) {
    result.jnd = changed(result.threshold, [&](double level) { return level - *standard; });
  }
  if (result.jnd && standard)
    result.weber = changed(*result.jnd, [&](double jnd) { return jnd / *standard; });
}

double log_coefficients(const std::vector<Block>& blocks) {
  double sum = 0.0;
  for (const Block& block : blocks) {
    const double k = static_cast<double>(block.correct), n = static_cast<double>(block.trials);
    sum += log_gamma(n + 1) - log_gamma(k + 1) - log_gamma(n - k + 1);
  }
  return sum;
}

void put_status(PsychometricResult& result) {
  const PsychometricFit& fit = result.fit;
  result.status = "fitted";
  if (fit.kind == FitKind::Flat) {
    result.status = "no rise";
    result.why_not =
        "the answers do not rise with the level: a slope of 0 is as likely as any other, and there is no "
        "threshold";
  } else if (fit.kind == FitKind::Step) {
    const Shape shape = result.request.model.shape;
    result.status = "separable";
    result.why_not =
        fit.step_lower == fit.step_upper
            ? fmt::format("a step at level {} is likelier than any function of finite slope",
                          from_scale(shape, fit.step_lower))
            : fmt::format(
                  "a step anywhere between levels {} and {} is likelier than any function of finite "
                  "slope; the threshold given is the middle",
                  from_scale(shape, fit.step_lower), from_scale(shape, fit.step_upper));
  }
}

Deviance judged(const PsychometricResult& result, double deviance, std::size_t summands) {
  double trials = 0.0;
  for (const Block& block : result.request.blocks) trials += static_cast<double>(block.trials);
  const double count = static_cast<double>(summands);
  Deviance judged{.value = deviance,
                  .degrees_of_freedom = count - static_cast<double>(free_parameters(result.request.model)),
                  .trials_each = trials / count};
  if (result.fit.kind == FitKind::Found && judged.degrees_of_freedom > 0 &&
      judged.trials_each >= kFewestTrials)
    judged.p_chi_squared =
        cdf(complement(boost::math::chi_squared_distribution<>(judged.degrees_of_freedom), judged.value));
  return judged;
}

void put_deviances(PsychometricResult& result, const Design& design, const std::vector<double>& correct) {
  const double height = result.fit.log_likelihood;
  const std::size_t blocks = correct.size(), levels = design.group.size() - 1;
  result.deviance = judged(result, deviance_of(design, correct, height), blocks);
  if (levels < blocks) result.by_level = judged(result, pooled_deviance_of(design, correct, height), levels);
}

}  // namespace

PsychometricResult psychometric_result(const PsychometricRequest& request, const Fitter* fitter,
                                       const PsychometricFit& fit, const std::vector<Replicate>& replicates) {
  PsychometricResult result{.request = request, .fit = fit};
  if (!fitter) {
    result.status = "unfit levels";
    result.why_not = unfit_levels(request.blocks, request.model);
    const Interval none{.lower = kNone, .upper = kNone, .level = request.level, .method = "none"};
    result.threshold = result.slope = result.lapse = {.value = kNone, .interval = none};
    result.log_likelihood = kNone;
    result.deviance = {.value = kNone, .degrees_of_freedom = kNone, .trials_each = kNone};
    return result;
  }
  put_status(result);
  const double at = request.model.threshold_at;
  const Intervals intervals(request, *fitter, fit, replicates);
  result.threshold = intervals.estimate(Measure::Level, at);
  result.slope = intervals.estimate(Measure::Slope, at);
  result.lapse = intervals.estimate(Measure::Lapse, at);
  put_discrimination(result, intervals);
  const auto correct = correct_in(fitter->design(), request.blocks);
  result.log_likelihood = fit.log_likelihood + log_coefficients(request.blocks);
  put_deviances(result, fitter->design(), correct);
  if (fit.kind == FitKind::Found && result.deviance.degrees_of_freedom > 0 &&
      request.bootstrap == Bootstrap::Parametric && !replicates.empty())
    result.p_bootstrap = deviance_p(replicates, result.deviance.value);
  result.blocks = block_influence(request.blocks, request.model, fit);
  return result;
}

}  // namespace palpate::analysis
