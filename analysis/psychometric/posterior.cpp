#include "analysis/psychometric/posterior.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "analysis/numerics/infinity.hpp"
#include "analysis/numerics/log_gamma.hpp"
#include "analysis/psychometric/bayes.hpp"
#include "analysis/psychometric/likelihood.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

double cosine(double share) {  // from 1 at 0 to 0 at 1
  return 0.5 * (1 + std::cos(std::numbers::pi * std::clamp(share, 0.0, 1.0)));
}

// The prior densities, up to a factor.
double threshold_prior(const BayesProblem& problem, double u) {
  const double outside = std::max({problem.design.place.front() - u, u - problem.design.place.back(), 0.0});
  return cosine(outside / (0.5 * problem.range));
}

double width_prior(const BayesProblem& problem, double width) {
  return cosine((2 * problem.gap - width) / problem.gap) *
         cosine((width - problem.range) / (2 * problem.range));
}

double beta_1_10(double rate) {
  return std::pow(1 - rate, 9);
}

double log_prior(const BayesProblem& problem, const BayesPoint& at) {
  const double density = threshold_prior(problem, at[kThreshold]) * width_prior(problem, at[kWidth]) *
                         beta_1_10(at[kLapse]) * beta_1_10(at[kEta]) *
                         (problem.guess_is_free ? beta_1_10(at[kGuess]) : 1.0);
  return density > 0 ? std::log(density) : -kInfinity;
}

}  // namespace

BayesProblem posed(std::span<const Block> blocks, Shape shape, std::optional<double> guess) {
  validate(blocks);
  const double guess_rate = guess.value_or(0.0);
  const PsychometricModel model{
      .shape = shape, .guess = guess_rate, .lapse_lower = 0, .lapse_upper = 0, .threshold_at = 0.5};
  validate(model);
  if (const auto unfit = unfit_levels(blocks, model)) throw std::invalid_argument(*unfit);
  BayesProblem problem{.design = make_design(blocks, model), .guess_is_free = !guess};
  problem.scale = {.origin = problem.design.centre, .unit = problem.design.half_range};
  problem.design = placed(std::move(problem.design), problem.scale);
  problem.correct = correct_in(problem.design, blocks);
  problem.unit_width = shape_quantile(shape, 0.95) - shape_quantile(shape, 0.05);
  problem.range = 2 * problem.design.half_range;
  problem.gap = problem.design.least_gap * problem.design.half_range;
  return problem;
}

std::vector<double> shape_over(const BayesProblem& problem, double threshold, double width) {
  const Shape shape = problem.design.model.shape;
  const double middle = shape_quantile(shape, 0.5), steepness = problem.unit_width / width;
  std::vector<double> below;
  for (const double place : problem.design.place)
    below.push_back(shape_at(shape, middle + steepness * (place - threshold)).below);
  return below;
}

double log_posterior(const BayesProblem& problem, const std::vector<double>& below, const BayesPoint& at) {
  const double prior = log_prior(problem, at);
  if (!std::isfinite(prior)) return prior;
  double sum = prior;
  for (std::size_t row = 0; row < below.size(); ++row) {
    const double psi = at[kGuess] + (1 - at[kGuess] - at[kLapse]) * below[row];
    sum += log_beta_binomial(problem.correct[row], problem.design.trials[row], psi, at[kEta]);
  }
  return sum;
}

std::vector<std::string> priors_in_words(const BayesProblem& problem) {
  const bool logs = on_log_levels(problem.design.model.shape);
  const std::string scale = logs ? "log level" : "level";
  const double low = problem.design.place.front(), high = problem.design.place.back();
  const auto place = [&](double u) { return number(problem.scale.to(u)); };
  const auto width = [&](double u) { return number(problem.scale.unit * u); };
  std::vector<std::string> words{
      fmt::format("threshold ({}): even from {} to {}, falling as a cosine to 0 at {} and {}", scale,
                  place(low), place(high), place(low - 0.5 * problem.range),
                  place(high + 0.5 * problem.range)),
      fmt::format("width ({}): even from {} to {}, falling as a cosine to 0 at {} and {}", scale,
                  width(2 * problem.gap), width(problem.range), width(problem.gap), width(3 * problem.range)),
      "lapse: beta(1, 10), up to 0.5", "eta: beta(1, 10)"};
  if (problem.guess_is_free) words.push_back("guess: beta(1, 10), up to 0.5");
  return words;
}

double log_beta_binomial(double k, double n, double psi, double eta) {
  const double p = std::clamp(psi, 1e-12, 1 - 1e-12);
  const double v = 1 / (eta * eta) - 1;
  if (v > 1e8) return log_binomial(k, n, p, 1 - p);  // apart by less than n^2/2e8, and free of round-off
  const double a = p * v, b = (1 - p) * v;
  return log_gamma(k + a) - log_gamma(a) + log_gamma(n - k + b) - log_gamma(b) + log_gamma(v) -
         log_gamma(n + v);
}

}  // namespace palpate::analysis
