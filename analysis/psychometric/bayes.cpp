#include "analysis/psychometric/bayes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlopt.hpp>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "analysis/psychometric/likelihood.hpp"
#include "analysis/words.hpp"

namespace palpate::analysis {
namespace {

constexpr std::size_t kThreshold = 0, kWidth = 1, kLapse = 2, kGuess = 3, kEta = 4, kParameters = 5;
constexpr double kMassive = 1e-4;  // of the greatest marginal density: what is below is left outside

using Point = std::array<double, kParameters>;
using Axes = std::array<std::vector<double>, kParameters>;

struct Problem {
  Design design{};
  std::vector<double> correct{};
  bool guess_is_free = false;
  double unit_width = 0.0;  // of the shape, in eta
  double range = 0.0, gap = 0.0;
};

double cosine(double share) {  // from 1 at 0 to 0 at 1
  return 0.5 * (1 + std::cos(std::numbers::pi * std::clamp(share, 0.0, 1.0)));
}

// The prior densities, up to a factor.
double threshold_prior(const Problem& problem, double u) {
  const double outside = std::max({problem.design.place.front() - u, u - problem.design.place.back(), 0.0});
  return cosine(outside / (0.5 * problem.range));
}

double width_prior(const Problem& problem, double width) {
  return cosine((2 * problem.gap - width) / problem.gap) *
         cosine((width - problem.range) / (2 * problem.range));
}

double beta_1_10(double rate) {
  return std::pow(1 - rate, 9);
}

double log_prior(const Problem& problem, const Point& at) {
  const double density = threshold_prior(problem, at[kThreshold]) * width_prior(problem, at[kWidth]) *
                         beta_1_10(at[kLapse]) * beta_1_10(at[kEta]) *
                         (problem.guess_is_free ? beta_1_10(at[kGuess]) : 1.0);
  return density > 0 ? std::log(density) : -INFINITY;
}

std::vector<double> shape_over(const Problem& problem, double threshold, double width) {
  const Shape shape = problem.design.model.shape;
  const double middle = shape_quantile(shape, 0.5), steepness = problem.unit_width / width;
  std::vector<double> below;
  for (const double place : problem.design.place)
    below.push_back(shape_at(shape, middle + steepness * (place - threshold)).below);
  return below;
}

double log_posterior(const Problem& problem, const std::vector<double>& below, const Point& at) {
  const double prior = log_prior(problem, at);
  if (!std::isfinite(prior)) return prior;
  double sum = prior;
  for (std::size_t row = 0; row < below.size(); ++row) {
    const double psi = at[kGuess] + (1 - at[kGuess] - at[kLapse]) * below[row];
    sum += log_beta_binomial(problem.correct[row], problem.design.trials[row], psi, at[kEta]);
  }
  return sum;
}

std::vector<double> spread(double from, double to, int steps) {
  std::vector<double> axis;
  for (int i = 0; i < steps; ++i) axis.push_back(steps == 1 ? from : from + (to - from) * i / (steps - 1));
  return axis;
}

double trapezoid_weight(const std::vector<double>& axis, std::size_t i) {
  if (axis.size() == 1) return 1.0;
  const double before = i > 0 ? axis[i] - axis[i - 1] : 0.0;
  const double after = i + 1 < axis.size() ? axis[i + 1] - axis[i] : 0.0;
  return 0.5 * (before + after);
}

struct Grid {
  Axes axes{};
  std::array<std::vector<double>, kParameters> marginal{};  // posterior density along each axis, unscaled
  Point best{};
};

// Calls visit(indices, point, log posterior) at every cell.
template <typename Visit>
void over_cells(const Problem& problem, const Axes& axes, const Visit& visit) {
  Point at{};
  std::array<std::size_t, kParameters> i{};
  for (i[0] = 0; i[0] < axes[0].size(); ++i[0]) {
    for (i[1] = 0; i[1] < axes[1].size(); ++i[1]) {
      at[kThreshold] = axes[0][i[0]];
      at[kWidth] = axes[1][i[1]];
      const std::vector<double> below = shape_over(problem, at[kThreshold], at[kWidth]);
      for (i[2] = 0; i[2] < axes[2].size(); ++i[2]) {
        for (i[3] = 0; i[3] < axes[3].size(); ++i[3]) {
          for (i[4] = 0; i[4] < axes[4].size(); ++i[4]) {
            at[kLapse] = axes[2][i[2]];
            at[kGuess] = axes[3][i[3]];
            at[kEta] = axes[4][i[4]];
            visit(i, at, log_posterior(problem, below, at));
          }
        }
      }
    }
  }
}

Grid filled(const Problem& problem, Axes axes) {
  Grid grid{.axes = std::move(axes)};
  std::vector<double> values;
  double greatest = -INFINITY;
  over_cells(problem, grid.axes, [&](const auto&, const Point& at, double value) {
    values.push_back(value);
    if (value > greatest) {
      greatest = value;
      grid.best = at;
    }
  });
  for (std::size_t p = 0; p < kParameters; ++p) grid.marginal[p].assign(grid.axes[p].size(), 0.0);
  std::array<std::vector<double>, kParameters> weight;
  for (std::size_t p = 0; p < kParameters; ++p) {
    for (std::size_t i = 0; i < grid.axes[p].size(); ++i)
      weight[p].push_back(trapezoid_weight(grid.axes[p], i));
  }
  std::size_t cell = 0;
  std::array<std::size_t, kParameters> i{};
  for (i[0] = 0; i[0] < weight[0].size(); ++i[0])
    for (i[1] = 0; i[1] < weight[1].size(); ++i[1])
      for (i[2] = 0; i[2] < weight[2].size(); ++i[2])
        for (i[3] = 0; i[3] < weight[3].size(); ++i[3])
          for (i[4] = 0; i[4] < weight[4].size(); ++i[4]) {
            double mass = std::exp(values[cell++] - greatest);
            for (std::size_t p = 0; p < kParameters; ++p) mass *= weight[p][i[p]];
            for (std::size_t p = 0; p < kParameters; ++p) grid.marginal[p][i[p]] += mass / weight[p][i[p]];
          }
  return grid;
}

// The same number of steps between the cells about what is likely.
std::vector<double> narrowed(const std::vector<double>& axis, const std::vector<double>& marginal,
                             int steps) {
  if (axis.size() == 1) return axis;
  const double least = kMassive * *std::max_element(marginal.begin(), marginal.end());
  std::size_t first = 0, last = axis.size() - 1;
  while (marginal[first] < least) ++first;
  while (marginal[last] < least) --last;
  return spread(axis[first > 0 ? first - 1 : 0], axis[std::min(last + 1, axis.size() - 1)], steps);
}

Interval credible(const std::vector<double>& axis, const std::vector<double>& marginal, double level) {
  std::vector<double> below{0.0};  // the distribution function, by the trapezoidal rule
  for (std::size_t i = 1; i < axis.size(); ++i)
    below.push_back(below.back() + 0.5 * (marginal[i] + marginal[i - 1]) * (axis[i] - axis[i - 1]));
  const auto quantile = [&](double p) {
    const double wanted = p * below.back();
    const auto i = static_cast<std::size_t>(
        std::clamp(std::lower_bound(below.begin(), below.end(), wanted) - below.begin(), std::ptrdiff_t{1},
                   std::ptrdiff_t(axis.size()) - 1));
    const double share = (wanted - below[i - 1]) / (below[i] - below[i - 1]);
    return axis[i - 1] + share * (axis[i] - axis[i - 1]);
  };
  return {.lower = quantile((1 - level) / 2),
          .upper = quantile((1 + level) / 2),
          .level = level,
          .method = "equal-tailed credible interval"};
}

Posterior summary(const Grid& grid, std::size_t p, const Point& mode, double level) {
  const std::vector<double>&axis = grid.axes[p], &marginal = grid.marginal[p];
  double mass = 0.0, moment = 0.0;
  for (std::size_t i = 0; i < axis.size(); ++i) {
    const double weight = trapezoid_weight(axis, i) * marginal[i];
    mass += weight;
    moment += weight * axis[i];
  }
  return {.mean = moment / mass, .mode = mode[p], .interval = credible(axis, marginal, level)};
}

struct Hill {
  const Problem& problem;
  Point start{};
  std::vector<std::size_t> free{};

  Point point(const double* of) const {
    Point at = start;
    for (std::size_t i = 0; i < free.size(); ++i) at[free[i]] = of[i];
    return at;
  }
};

double height(unsigned, const double* of, double*, void* data) {
  const Hill& hill = *static_cast<const Hill*>(data);
  const Point at = hill.point(of);
  const auto below = shape_over(hill.problem, at[kThreshold], at[kWidth]);
  return std::max(log_posterior(hill.problem, below, at), -1e12);
}

// Uphill from the best cell, within the priors.
Point refined_mode(const Problem& problem, const Axes& bounds, const Point& start) {
  Hill hill{.problem = problem, .start = start, .free = {kThreshold, kWidth, kLapse, kEta}};
  if (problem.guess_is_free) hill.free.push_back(kGuess);
  std::vector<double> lower, upper, x, step;
  for (const std::size_t p : hill.free) {
    lower.push_back(bounds[p].front());
    upper.push_back(bounds[p].back());
    x.push_back(start[p]);
    step.push_back(0.01 * (bounds[p].back() - bounds[p].front()));
  }
  nlopt::opt search(nlopt::LN_SBPLX, static_cast<unsigned>(hill.free.size()));
  search.set_lower_bounds(lower);
  search.set_upper_bounds(upper);
  search.set_initial_step(step);
  search.set_xtol_rel(1e-8);
  search.set_maxeval(20'000);
  search.set_max_objective(height, &hill);
  double value = 0.0;
  search.optimize(x, value);
  return hill.point(x.data());
}

Problem posed(std::span<const Block> blocks, Shape shape, std::optional<double> guess) {
  validate(blocks);
  const double guess_rate = guess.value_or(0.0);
  const PsychometricModel model{
      .shape = shape, .guess = guess_rate, .lapse_lower = 0, .lapse_upper = 0, .threshold_at = 0.5};
  validate(model);
  if (const auto unfit = unfit_levels(blocks, model)) throw std::invalid_argument(*unfit);
  Problem problem{.design = make_design(blocks, model), .guess_is_free = !guess};
  problem.correct = correct_in(problem.design, blocks);
  problem.unit_width = shape_quantile(shape, 0.95) - shape_quantile(shape, 0.05);
  problem.range = 2 * problem.design.half_range;
  problem.gap = problem.design.least_gap * problem.design.half_range;
  return problem;
}

std::vector<std::string> priors_in_words(const Problem& problem) {
  const bool logs = on_log_levels(problem.design.model.shape);
  const std::string scale = logs ? "log level" : "level";
  const double low = problem.design.place.front(), high = problem.design.place.back();
  std::vector<std::string> words{
      fmt::format("threshold ({}): even from {} to {}, falling as a cosine to 0 at {} and {}", scale,
                  number(low), number(high), number(low - 0.5 * problem.range),
                  number(high + 0.5 * problem.range)),
      fmt::format("width ({}): even from {} to {}, falling as a cosine to 0 at {} and {}", scale,
                  number(2 * problem.gap), number(problem.range), number(problem.gap),
                  number(3 * problem.range)),
      "lapse: beta(1, 10), up to 0.5", "eta: beta(1, 10)"};
  if (problem.guess_is_free) words.push_back("guess: beta(1, 10), up to 0.5");
  return words;
}

}  // namespace

double log_beta_binomial(double k, double n, double psi, double eta) {
  const double p = std::clamp(psi, 1e-12, 1 - 1e-12);
  const double v = 1 / (eta * eta) - 1;
  if (v > 1e8) return log_binomial(k, n, p, 1 - p);  // apart by less than n^2/2e8, and free of round-off
  const double a = p * v, b = (1 - p) * v;
  return std::lgamma(k + a) - std::lgamma(a) + std::lgamma(n - k + b) - std::lgamma(b) + std::lgamma(v) -
         std::lgamma(n + v);
}

BayesianFit bayesian_psychometric(std::span<const Block> blocks, Shape shape, std::optional<double> guess,
                                  double level) {
  require_level(level, "level");
  const Problem problem = posed(blocks, shape, guess);
  const double low = problem.design.place.front(), high = problem.design.place.back();
  const bool free = problem.guess_is_free;
  const std::array<int, kParameters> coarse{23, 23, 7, free ? 7 : 1, 7};
  const std::array<int, kParameters> fine =
      free ? std::array{31, 31, 11, 11, 9} : std::array{45, 45, 21, 1, 13};
  const Axes bounds{spread(low - 0.5 * problem.range, high + 0.5 * problem.range, coarse[kThreshold]),
                    spread(problem.gap, 3 * problem.range, coarse[kWidth]), spread(0.0, 0.5, coarse[kLapse]),
                    free ? spread(0.0, 0.5, coarse[kGuess]) : std::vector<double>{*guess},
                    spread(0.0, 1.0 - 1e-10, coarse[kEta])};
  Grid grid = filled(problem, bounds);
  for (const auto& steps : {coarse, fine}) {
    Axes axes;
    for (std::size_t p = 0; p < kParameters; ++p)
      axes[p] = narrowed(grid.axes[p], grid.marginal[p], steps[p]);
    grid = filled(problem, std::move(axes));
  }
  const Point mode = refined_mode(problem, bounds, grid.best);
  BayesianFit fit{.threshold = summary(grid, kThreshold, mode, level),
                  .width = summary(grid, kWidth, mode, level),
                  .lapse = summary(grid, kLapse, mode, level),
                  .eta = summary(grid, kEta, mode, level),
                  .priors = priors_in_words(problem),
                  .grid = 1,
                  .method = {.name = "Bayesian beta-binomial psychometric function over a grid",
                             .source = "Schuett et al. 2016"}};
  if (free) fit.guess = summary(grid, kGuess, mode, level);
  for (const auto& axis : grid.axes) fit.grid *= static_cast<long>(axis.size());
  for (double* value : {&fit.threshold.mean, &fit.threshold.mode, &fit.threshold.interval.lower,
                        &fit.threshold.interval.upper})
    *value = from_scale(shape, *value);
  return fit;
}

}  // namespace palpate::analysis
