#include "analysis/psychometric/compare.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <stdexcept>

#include "analysis/numerics/infinity.hpp"
#include "analysis/psychometric/search.hpp"

namespace palpate::analysis {
namespace {

constexpr int kScan = 40, kLapseScan = 10;

struct Prepared {
  Design design{};
  std::vector<double> correct{};
};

using Conditions = std::vector<Prepared>;

Prepared prepared(std::span<const Block> blocks, const PsychometricModel& model) {
  Prepared one{.design = make_design(blocks, model)};
  one.correct = correct_in(one.design, blocks);
  return one;
}

PsychometricFit fit_at(const Prepared& one, double lapse) {
  Design design = one.design;
  design.model.lapse_lower = design.model.lapse_upper = lapse;
  return fit_psychometric(design, one.correct);
}

// The greatest over the lapse rate that all share of what `height` finds at one rate.
template <typename Height>
Greatest over_lapse(const PsychometricModel& model, const Height& height) {
  if (!lapse_is_free(model)) return {model.lapse_lower, height(model.lapse_lower)};
  return greatest(height, model.lapse_lower, model.lapse_upper, kLapseScan);
}

JointFit fit_separate(const Conditions& conditions, const PsychometricModel& model) {
  const auto height = [&](double lapse) {
    double sum = 0.0;
    for (const Prepared& one : conditions) sum += fit_at(one, lapse).log_likelihood;
    return sum;
  };
  const Greatest best = over_lapse(model, height);
  JointFit joint{.lapse = best.at, .log_likelihood = best.value};
  for (const Prepared& one : conditions) {
    const PsychometricFit fit = fit_at(one, best.at);
    joint.alpha.push_back(fit.alpha);
    joint.beta.push_back(fit.beta);
  }
  return joint;
}

JointFit fit_pooled(std::span<const PsychometricCondition> conditions, const PsychometricModel& model) {
  std::vector<Block> all;
  for (const PsychometricCondition& condition : conditions)
    all.insert(all.end(), condition.blocks.begin(), condition.blocks.end());
  const Prepared pooled = prepared(all, model);
  const PsychometricFit fit = fit_psychometric(pooled.design, pooled.correct);
  return {.alpha = std::vector<double>(conditions.size(), fit.alpha),
          .beta = std::vector<double>(conditions.size(), fit.beta),
          .lapse = fit.lapse,
          .log_likelihood = fit.log_likelihood};
}

// One parameter is shared, the other each condition's own.
class Sharing {
 public:
  Sharing(const Conditions& conditions, const PsychometricModel& model, Same same)
      : conditions_(conditions), model_(model), same_(same) {
    lowest_ = highest_ = conditions.front().design.centre;
    double gap = kInfinity;
    for (const Prepared& one : conditions) {
      lowest_ = std::min(lowest_, one.design.place.front());
      highest_ = std::max(highest_, one.design.place.back());
      gap = std::min(gap, one.design.least_gap * one.design.half_range);
    }
    const double range = highest_ - lowest_;
    flattest_ = std::log(0.02 / range);
    steepest_ = std::log(60 / gap);
    lowest_ -= range;
    highest_ += range;
    quantile_ = shape_quantile(model.shape, model.threshold_at);
  }

  JointFit fit() const {
    const Greatest lapse = over_lapse(model_, [&](double rate) { return shared(rate).value; });
    JointFit joint{.lapse = lapse.at, .log_likelihood = lapse.value};
    const double held = shared(lapse.at).at;
    for (const Prepared& one : conditions_) {
      const double free = own(one, lapse.at, held).at;
      joint.alpha.push_back(alpha(held, free));
      joint.beta.push_back(beta(held, free));
    }
    return joint;
  }

 private:
  double beta(double held, double free) const { return std::exp(same_ == Same::Threshold ? free : held); }
  double alpha(double held, double free) const {
    return same_ == Same::Threshold ? held - quantile_ / beta(held, free) : free;
  }
  Greatest own(const Prepared& one, double lapse, double held) const {
    const auto height = [&](double free) {
      const Line line = line_of(one.design, alpha(held, free), beta(held, free), lapse);
      return log_likelihood(one.design, one.correct, line);
    };
    return same_ == Same::Threshold ? greatest(height, flattest_, steepest_, kScan)
                                    : greatest(height, lowest_, highest_, kScan);
  }
  Greatest shared(double lapse) const {
    const auto height = [&](double held) {
      double sum = 0.0;
      for (const Prepared& one : conditions_) sum += own(one, lapse, held).value;
      return sum;
    };
    return same_ == Same::Threshold ? greatest(height, lowest_, highest_, kScan)
                                    : greatest(height, flattest_, steepest_, kScan);
  }

  const Conditions& conditions_;
  const PsychometricModel& model_;
  Same same_;
  double lowest_ = 0.0, highest_ = 0.0;     // of places
  double flattest_ = 0.0, steepest_ = 0.0;  // of log beta
  double quantile_ = 0.0;
};

// The middle and half the range of all levels: where they stand and what their unit is decides nothing.
Placement common_scale(const Conditions& conditions) {
  double low = kInfinity, high = -kInfinity;
  for (const Prepared& one : conditions) {
    low = std::min(low, one.design.place.front());
    high = std::max(high, one.design.place.back());
  }
  return {.origin = 0.5 * (low + high), .unit = 0.5 * (high - low)};
}

JointFit placed_back(JointFit joint, const Placement& on) {
  for (double& alpha : joint.alpha) alpha = on.to(alpha);
  for (double& beta : joint.beta) beta /= on.unit;
  return joint;
}

std::optional<std::string> why_no_function(const PsychometricCondition& condition, double beta) {
  if (std::isinf(beta))
    return fmt::format("condition {}: its answers are separable, its slope infinite", condition.name);
  if (beta == 0) return fmt::format("condition {}: its answers do not rise with the level", condition.name);
  return std::nullopt;
}

}  // namespace

Same same_from_name(std::string_view name) {
  for (const Same same : {Same::Function, Same::Threshold, Same::Slope}) {
    if (name == name_of(same)) return same;
  }
  throw std::invalid_argument(fmt::format("same is '{}'; accepted: function, threshold, slope", name));
}

std::string_view name_of(Same same) {
  switch (same) {
    case Same::Function:
      return "function";
    case Same::Threshold:
      return "threshold";
    case Same::Slope:
      break;
  }
  return "slope";
}

PsychometricComparison compare_psychometric(std::span<const PsychometricCondition> conditions,
                                            const PsychometricModel& model, Same same) {
  validate(model);
  if (conditions.size() < 2)
    throw std::invalid_argument(fmt::format("{} condition; a comparison needs two", conditions.size()));
  PsychometricComparison comparison{
      .method = {.name = "likelihood ratio test of psychometric functions, chi-squared distribution",
                 .source = "Wilks 1938; Prins & Kingdom 2018"}};
  Conditions all;
  for (const PsychometricCondition& condition : conditions) {
    validate(condition.blocks);
    if (const auto unfit = unfit_levels(condition.blocks, model)) {
      comparison.why_not = fmt::format("condition {}: {}", condition.name, *unfit);
      return comparison;
    }
    all.push_back(prepared(condition.blocks, model));
  }
  const Placement on = common_scale(all);
  for (Prepared& one : all) one.design = placed(std::move(one.design), on);
  comparison.separate = placed_back(fit_separate(all, model), on);
  for (std::size_t i = 0; i < conditions.size() && !comparison.why_not; ++i)
    comparison.why_not = why_no_function(conditions[i], comparison.separate.beta[i]);
  if (comparison.why_not) return comparison;
  comparison.same = same == Same::Function ? fit_pooled(conditions, model)
                                           : placed_back(Sharing(all, model, same).fit(), on);
  comparison.chi_squared =
      std::max(0.0, 2 * (comparison.separate.log_likelihood - comparison.same.log_likelihood));
  comparison.degrees_of_freedom =
      static_cast<double>((conditions.size() - 1) * (same == Same::Function ? 2 : 1));
  comparison.p = cdf(complement(boost::math::chi_squared_distribution<>(comparison.degrees_of_freedom),
                                comparison.chi_squared));
  return comparison;
}

}  // namespace palpate::analysis
