#include "analysis/psychometric/bayes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlopt.hpp>

#include "analysis/numerics/infinity.hpp"
#include "analysis/psychometric/posterior.hpp"

namespace palpate::analysis {
namespace {

constexpr double kMassive = 1e-4;  // of the greatest marginal density: what is below is left outside

using Axes = std::array<std::vector<double>, kParameters>;

std::vector<double> spread(double from, double to, int steps) {
  std::vector<double> axis;
  axis.reserve(steps);
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
  BayesPoint best{};
};

// Calls visit(indices, point, log posterior) at every cell.
template <typename Visit>
void over_cells(const BayesProblem& problem, const Axes& axes, const Visit& visit) {
  BayesPoint at{};
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

Grid filled(const BayesProblem& problem, Axes axes) {
  Grid grid{.axes = std::move(axes)};
  std::vector<double> values;
  double greatest = -kInfinity;
  over_cells(problem, grid.axes, [&](const auto&, const BayesPoint& at, double value) {
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
  const double least = kMassive * *std::ranges::max_element(marginal);
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
    const auto i = std::clamp(std::ranges::lower_bound(below, wanted) - below.begin(), std::ptrdiff_t{1},
                              std::ptrdiff_t(axis.size()) - 1);
    const double share = (wanted - below[i - 1]) / (below[i] - below[i - 1]);
    return axis[i - 1] + share * (axis[i] - axis[i - 1]);
  };
  return {.lower = quantile((1 - level) / 2),
          .upper = quantile((1 + level) / 2),
          .level = level,
          .method = "equal-tailed credible interval"};
}

Posterior summary(const Grid& grid, std::size_t p, const BayesPoint& mode, double level) {
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
  const BayesProblem& problem;
  BayesPoint start{};
  std::vector<std::size_t> free{};

  BayesPoint point(const double* of) const {
    BayesPoint at = start;
    for (std::size_t i = 0; i < free.size(); ++i) at[free[i]] = of[i];
    return at;
  }
};

double height(unsigned, const double* of, double*, void* data) {
  const Hill& hill = *static_cast<const Hill*>(data);
  const BayesPoint at = hill.point(of);
  const auto below = shape_over(hill.problem, at[kThreshold], at[kWidth]);
  return std::max(log_posterior(hill.problem, below, at), -1e12);
}

// Uphill from the best cell, within the priors.
BayesPoint refined_mode(const BayesProblem& problem, const Axes& bounds, const BayesPoint& start) {
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
  search.set_xtol_abs(1e-9);  // places are of order 1, and may be 0
  search.set_maxeval(20'000);
  search.set_max_objective(height, &hill);
  double value = 0.0;
  search.optimize(x, value);
  return hill.point(x.data());
}

}  // namespace

BayesianFit bayesian_psychometric(std::span<const Block> blocks, Shape shape, std::optional<double> guess,
                                  double level) {
  require_level(level, "level");
  const BayesProblem problem = posed(blocks, shape, guess);
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
  const BayesPoint mode = refined_mode(problem, bounds, grid.best);
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
  const auto back = [](Posterior& of, const auto& change) {
    for (double* value : {&of.mean, &of.mode, &of.interval.lower, &of.interval.upper})
      *value = change(*value);
  };
  back(fit.threshold, [&](double place) { return from_scale(shape, problem.scale.to(place)); });
  back(fit.width, [&](double width) { return problem.scale.unit * width; });
  return fit;
}

}  // namespace palpate::analysis
