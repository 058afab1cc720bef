#include "analysis/psychometric/profile.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <functional>
#include <vector>

#include "analysis/numerics/infinity.hpp"
#include "analysis/psychometric/limits.hpp"
#include "analysis/psychometric/measures.hpp"
#include "analysis/psychometric/search.hpp"

namespace palpate::analysis {
namespace {

constexpr int kProfileScan = 40;  // values of the free parameter before the maximum is refined
constexpr double kFar = 100.0;    // ranges of levels from the levels: a threshold beyond is none

// A measure's value on an axis along which it is searched: the place u for a level, else the logarithm.
struct Axis {
  std::function<double(double)> value;      // of the measure
  std::function<double(double)> free_from;  // range of the free parameter at a place on the axis
  std::function<double(double)> free_to;
  std::function<Line(double, double)> line;  // (place on the axis, free parameter), lapse left out
  double estimate = 0.0;
  double step = 0.0;  // first step away from the estimate
  double least = 0.0, most = 0.0;
};

// The greatest log likelihood over the lapse rate. psi is linear in it, so that the likelihood is concave.
double best_over_lapse(const Design& design, std::span<const double> correct, Line line) {
  const PsychometricModel& model = design.model;
  std::vector<ShapeValue> shape(correct.size());
  for (std::size_t row = 0; row < shape.size(); ++row)
    shape[row] = shape_at(model.shape, line.intercept + line.rise * design.v[row]);
  const auto slope = [&](double lapse) {
    double sum = 0.0;
    const double span = 1 - model.guess - lapse;
    for (std::size_t row = 0; row < shape.size(); ++row) {
      const double hits = correct[row], misses = design.trials[row] - hits;
      if (hits > 0) sum -= hits * shape[row].below / (model.guess + span * shape[row].below);
      if (misses > 0) sum += misses * shape[row].below / (lapse + span * shape[row].above);
    }
    return sum;
  };
  double lower = model.lapse_lower, upper = model.lapse_upper;
  if (!lapse_is_free(model) || !(slope(lower) > 0)) {
    line.lapse = lower;
  } else if (!(slope(upper) < 0)) {
    line.lapse = upper;
  } else {
    for (int i = 0; i < 45; ++i) {
      const double middle = 0.5 * (lower + upper);
      (slope(middle) > 0 ? lower : upper) = middle;
    }
    line.lapse = 0.5 * (lower + upper);
  }
  return log_likelihood(design, correct, line);
}

double best_over_free(const Design& design, std::span<const double> correct, const Axis& axis, double place) {
  const double from = axis.free_from(place), to = axis.free_to(place);
  const auto height = [&](double free) { return best_over_lapse(design, correct, axis.line(place, free)); };
  return greatest(height, from, to, kProfileScan).value;
}

Axis level_axis(const Design& design, double at) {
  const double q = shape_quantile(design.model.shape, at), range = 2 * design.half_range;
  const double flattest = std::log(1e-3 / range);
  const double steepest = std::log(60 / (design.least_gap * design.half_range));
  return {.value = [&design](double place) { return from_scale(design.model.shape, place); },
          .free_from = [flattest](double) { return flattest; },
          .free_to = [steepest](double) { return steepest; },
          .line =
              [&design, q](double place, double log_beta) {
                const double beta = std::exp(log_beta);
                return line_of(design, place - q / beta, beta, 0.0);
              },
          .step = 0.02 * range,
          .least = design.centre - kFar * range,
          .most = design.centre + kFar * range};
}

// Slope and half distance: `beta_of` the place where levels are as they are, so that the place of the
// function stays free; on log levels `alpha_of` the place and beta, which stays free instead.
Axis steepness_axis(const Design& design, const std::function<double(double)>& beta_of,
                    const std::function<double(double, double)>& alpha_of) {
  Axis axis = level_axis(design, 0.5);
  axis.value = [](double place) { return std::exp(place); };
  axis.step = 0.05;
  axis.least = -kInfinity;
  axis.most = kInfinity;
  if (on_log_levels(design.model.shape)) {
    axis.line = [&design, alpha_of](double place, double log_beta) {
      return line_of(design, alpha_of(place, std::exp(log_beta)), std::exp(log_beta), 0.0);
    };
    return axis;
  }
  const auto reach = [&design, beta_of](double place) {
    return 1.2 * design.half_range + std::min(8 / beta_of(place), 50 * design.half_range);
  };
  axis.free_from = [&design, reach](double place) { return design.centre - reach(place); };
  axis.free_to = [&design, reach](double place) { return design.centre + reach(place); };
  axis.line = [&design, beta_of](double place, double alpha) {
    return line_of(design, alpha, beta_of(place), 0.0);
  };
  return axis;
}

Axis slope_axis(const Design& design, double at) {
  const Shape shape = design.model.shape;
  const double q = shape_quantile(shape, at), density = shape_at(shape, q).density;
  return steepness_axis(
      design, [density](double place) { return std::exp(place) / density; },
      [=](double place, double beta) { return std::log(beta * density) - place - q / beta; });
}

Axis half_distance_axis(const Design& design) {
  const Shape shape = design.model.shape;
  const double low = shape_quantile(shape, 0.25), high = shape_quantile(shape, 0.75);
  return steepness_axis(
      design, [=](double place) { return 0.5 * (high - low) / std::exp(place); },
      [=](double place, double beta) {
        return place - std::log(0.5 * (std::exp(high / beta) - std::exp(low / beta)));
      });
}

Axis axis_of(const Design& design, Measure measure, double at) {
  if (measure == Measure::Level) return level_axis(design, at);
  return measure == Measure::Slope ? slope_axis(design, at) : half_distance_axis(design);
}

// From the estimate outwards in growing steps to the first place below the cut, then back to the crossing.
// Infinite where the search leaves [least, most].
double end_of(const Axis& axis, const std::function<double(double)>& excess, double direction) {
  double inside = axis.estimate, step = axis.step;
  double inner = excess(inside);
  while (true) {
    const double outside = inside + direction * step;
    if (outside < axis.least || outside > axis.most) return direction * kInfinity;
    const double outer = excess(outside);
    if (outer <= 0) {
      if (inner <= 0) return inside;  // the estimate itself, to round-off
      std::uintmax_t iterations = 60;
      const auto ends = boost::math::tools::toms748_solve(
          excess, std::min(inside, outside), std::max(inside, outside), direction > 0 ? inner : outer,
          direction > 0 ? outer : inner, boost::math::tools::eps_tolerance<double>(44), iterations);
      return 0.5 * (ends.first + ends.second);
    }
    inside = outside;
    inner = outer;
    step *= 1.5;
  }
}

// The scale on which ends are searched: v, or, where levels are logarithms and a slope asks for levels as they
// are, u from the middle of the levels.
Placement standard_scale(const Design& design) {
  return {.origin = design.centre, .unit = on_log_levels(design.model.shape) ? 1.0 : design.half_range};
}

// How many of its units a level holds.
double unit_of_levels(const Placement& on, Shape shape) {
  return on_log_levels(shape) ? std::exp(on.origin) : on.unit;
}

// Where the search for the ends of a slope or a half distance begins, a start also where the fit is a limit.
double steepness_at(const Design& design, const PsychometricFit& fit, Measure measure, double at) {
  const Shape shape = design.model.shape;
  const double steepest = 50 / (design.least_gap * design.half_range);
  const double beta = std::clamp(fit.beta, 1e-3 / design.half_range, steepest);
  const double alpha = std::isnan(fit.alpha) ? design.centre : fit.alpha;
  return std::log(measure == Measure::Slope ? slope_at(shape, alpha, beta, at)
                                            : half_distance(shape, alpha, beta));
}

double profile_of_lapse(const Design& design, std::span<const double> correct, double lapse) {
  Design fixed = design;
  fixed.model.lapse_lower = fixed.model.lapse_upper = lapse;
  return fit_psychometric(fixed, correct).log_likelihood;
}

void lapse_ends(Interval& interval, const Design& design, std::span<const double> correct, double estimate,
                double cut) {
  const auto excess = [&](double lapse) { return profile_of_lapse(design, correct, lapse) - cut; };
  const auto end = [&](double bound) {
    const double at_bound = excess(bound);
    if (at_bound >= 0 || bound == estimate) return bound;
    double inside = estimate, outside = bound;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (inside + outside);
      (excess(middle) >= 0 ? inside : outside) = middle;
    }
    return inside;
  };
  interval.lower = end(design.model.lapse_lower);
  interval.upper = end(design.model.lapse_upper);
}

}  // namespace

double profile_log_likelihood(const Fitter& fitter, std::span<const double> correct, Measure measure,
                              double at, double value) {
  if (measure == Measure::Lapse) return profile_of_lapse(fitter.design(), correct, value);
  const Placement on = standard_scale(fitter.design());
  const Design design = placed(fitter.design(), on);
  const Axis axis = axis_of(design, measure, at);
  const double unit = unit_of_levels(on, design.model.shape);
  const double place = measure == Measure::Level   ? on.from(to_scale(design.model.shape, value))
                       : measure == Measure::Slope ? std::log(value * unit)
                                                   : std::log(value / unit);
  return best_over_free(design, correct, axis, place);
}

Interval profile_interval(const Fitter& fitter, std::span<const double> correct, const PsychometricFit& fit,
                          Measure measure, double at, double level) {
  require_level(level, "confidence level");
  const Placement on = standard_scale(fitter.design());
  const Design design = placed(fitter.design(), on);
  const PsychometricFit there = placed(fit, design, on);
  const Shape shape = design.model.shape;
  Interval interval{.lower = -kInfinity, .upper = kInfinity, .level = level, .method = "profile likelihood"};
  const double cut = there.log_likelihood - 0.5 * quantile(boost::math::chi_squared_distribution<>(1), level);
  if (measure == Measure::Lapse) {
    const double inside = there.kind == FitKind::Flat ? design.model.lapse_lower : there.lapse;
    lapse_ends(interval, design, correct, inside, cut);
    return interval;
  }
  if (measure != Measure::Level || on_log_levels(shape)) interval.lower = 0.0;
  Axis axis = axis_of(design, measure, at);
  const auto excess = [&](double place) { return best_over_free(design, correct, axis, place) - cut; };
  // A function that does not rise has no threshold, or any; one that is a step has no finite slope.
  const bool may_be_flat = best_flat(design, correct).log_likelihood >= cut;
  const bool may_be_step = best_step(design, correct).log_likelihood >= cut;
  if (measure == Measure::Level) {
    if (may_be_flat) return interval;
    axis.estimate = place_at(there, shape, at);
    interval.lower = from_scale(shape, on.to(end_of(axis, excess, -1)));
    interval.upper = from_scale(shape, on.to(end_of(axis, excess, 1)));
    return interval;
  }
  const bool slope = measure == Measure::Slope;
  axis.estimate = steepness_at(design, there, measure, at);
  const double unit = unit_of_levels(on, shape), of_levels = slope ? 1 / unit : unit;
  if (!(slope ? may_be_flat : may_be_step)) interval.lower = std::exp(end_of(axis, excess, -1)) * of_levels;
  if (!(slope ? may_be_step : may_be_flat)) interval.upper = std::exp(end_of(axis, excess, 1)) * of_levels;
  return interval;
}

}  // namespace palpate::analysis
