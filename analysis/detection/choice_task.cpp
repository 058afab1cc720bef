#include "analysis/detection/choice_task.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/differentiation/finite_difference.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "analysis/numerics/infinity.hpp"
#include "analysis/numerics/standard_normal.hpp"

namespace palpate::analysis {
namespace {

using boost::math::tools::toms748_solve;
using Quadrature = boost::math::quadrature::gauss_kronrod<double, 61>;

constexpr double kReach = 10.0;    // standard deviations: 1e-23 of the noise lies beyond
constexpr double kLargest = 50.0;  // d' at which every task is certain to the last digit

template <typename Function>
double integral(const Function& f, double from, double to) {
  return from < to ? Quadrature::integrate(f, from, to, 12, 1e-13) : 0.0;
}

double alternatives_correct(int m, double d) {
  if (m == 2) return Phi(d / std::numbers::sqrt2);
  return integral([&](double x) { return phi(x - d) * std::pow(Phi(x), m - 1); }, d - kReach, d + kReach);
}

double triangle_correct(double d) {
  const double shift = d * std::sqrt(2.0 / 3.0);
  const auto f = [&](double x) {
    const double distance = x * std::numbers::sqrt3;
    return (Phi(shift - distance) + Phi(-shift - distance)) * phi(x);
  };
  return 2 * integral(f, 0, kReach);
}

// Means -d/2 and d/2. The odd one x beats both others when these lie on the other side of zero and nearer to
// their own end than x: the others negative and below x, or positive and above it.
double oddity_of_independent_observations(double d) {
  const auto above = [&](double x) { return phi(x - d / 2) * std::pow(Phi(std::min(x, 0.0) + d / 2), 2); };
  const auto below = [&](double x) { return phi(x - d / 2) * std::pow(Phi(-std::max(x, 0.0) - d / 2), 2); };
  const auto both = [&](double x) { return above(x) + below(x); };
  const double from = std::min(0.0, d / 2 - kReach), to = std::max(0.0, d / 2 + kReach);
  return integral(both, from, 0) + integral(both, 0, to);
}

double abx_correct(double d, Strategy strategy) {
  const double order = d / std::numbers::sqrt2;  // of A and B
  const double match = d / (strategy == Strategy::Differencing ? std::sqrt(6.0) : 2.0);
  return Phi(order) * Phi(match) + Phi(-order) * Phi(-match);
}

[[noreturn]] void refuse(std::string_view name, std::string_view what) {
  throw std::invalid_argument(fmt::format("task {} {}", name, what));
}

ChoiceKind kind_from_name(std::string_view name) {
  if (name == "2IFC") return ChoiceKind::TwoInterval;
  if (name == "2AFC") return ChoiceKind::TwoAlternative;
  if (name == "m-AFC") return ChoiceKind::Alternatives;
  if (name == "triangle") return ChoiceKind::Triangle;
  if (name == "oddity") return ChoiceKind::Oddity;
  if (name == "ABX") return ChoiceKind::Abx;
  throw std::invalid_argument(
      fmt::format("task is '{}'; accepted: 2IFC, 2AFC, m-AFC, triangle, oddity, ABX", name));
}

}  // namespace

Strategy strategy_from_name(std::string_view name) {
  if (name == "differencing") return Strategy::Differencing;
  if (name == "independent-observations") return Strategy::IndependentObservations;
  throw std::invalid_argument(
      fmt::format("strategy is '{}'; accepted: differencing, independent-observations", name));
}

std::string_view name_of(Strategy strategy) {
  return strategy == Strategy::Differencing ? "differencing" : "independent-observations";
}

ChoiceTask choice_task(std::string_view name, std::optional<long> alternatives,
                       std::optional<Strategy> strategy) {
  ChoiceTask task{.kind = kind_from_name(name), .strategy = strategy};
  if (task.kind == ChoiceKind::Alternatives) {
    if (!alternatives) refuse(name, "needs alternatives: how many there are to choose from");
    if (*alternatives < 2 || *alternatives > 1000) {
      refuse(name, fmt::format("with {} alternatives; accepted: 2 to 1000", *alternatives));
    }
    task.alternatives = static_cast<int>(*alternatives);
  } else {
    if (alternatives) refuse(name, "takes no alternatives; only m-AFC does");
    const bool three = task.kind == ChoiceKind::Triangle || task.kind == ChoiceKind::Oddity;
    task.alternatives = three ? 3 : 2;
  }
  const bool open = task.kind == ChoiceKind::Oddity || task.kind == ChoiceKind::Abx;
  if (open && !strategy) {
    refuse(name,
           "needs a strategy: differencing (stimuli rove) or independent-observations (two stimuli, well "
           "known)");
  }
  if (!open && strategy) refuse(name, "takes no strategy; only oddity and ABX do");
  return task;
}

std::string name_of(const ChoiceTask& task) {
  switch (task.kind) {
    case ChoiceKind::TwoInterval:
      return "2IFC";
    case ChoiceKind::TwoAlternative:
      return "2AFC";
    case ChoiceKind::Alternatives:
      return "m-AFC";
    case ChoiceKind::Triangle:
      return "triangle";
    case ChoiceKind::Oddity:
      return "oddity";
    case ChoiceKind::Abx:
      break;
  }
  return "ABX";
}

double chance_of(const ChoiceTask& task) {
  return 1.0 / task.alternatives;
}

bool knows_direction(const ChoiceTask& task) {
  return task.kind == ChoiceKind::TwoInterval || task.kind == ChoiceKind::TwoAlternative ||
         task.kind == ChoiceKind::Alternatives;
}

double proportion_correct(const ChoiceTask& task, double d_prime) {
  if (knows_direction(task)) return alternatives_correct(task.alternatives, d_prime);
  if (task.kind == ChoiceKind::Abx) return abx_correct(d_prime, task.strategy.value());
  const bool differencing = task.strategy.value_or(Strategy::Differencing) == Strategy::Differencing;
  return differencing ? triangle_correct(d_prime) : oddity_of_independent_observations(std::abs(d_prime));
}

double d_prime_at(const ChoiceTask& task, double proportion) {
  if (!knows_direction(task) && proportion <= chance_of(task)) return 0.0;
  if (proportion <= 0) return -kInfinity;
  if (proportion >= 1) return kInfinity;
  if (knows_direction(task) && task.alternatives == 2) {
    return std::numbers::sqrt2 * quantile(boost::math::normal(), proportion);
  }
  const auto excess = [&](double d) { return proportion_correct(task, d) - proportion; };
  const double sign = proportion < chance_of(task) ? -1.0 : 1.0;
  double reach = 1.0;
  while (reach < kLargest && sign * excess(sign * reach) < 0) reach *= 2;
  if (sign * excess(sign * reach) <= 0) return sign * reach;  // only rounding lies between it and certainty
  std::uintmax_t steps = 200;
  const auto [lower, upper] = toms748_solve(excess, std::min(0.0, sign * reach), std::max(0.0, sign * reach),
                                            boost::math::tools::eps_tolerance<double>(50), steps);
  return (lower + upper) / 2;
}

double slope_at(const ChoiceTask& task, double d_prime) {
  if (!knows_direction(task) && d_prime == 0) return 0.0;  // a minimum
  if (knows_direction(task) && task.alternatives == 2) {
    return phi(d_prime / std::numbers::sqrt2) / std::numbers::sqrt2;
  }
  const auto f = [&](double d) { return proportion_correct(task, d); };
  return boost::math::differentiation::finite_difference_derivative<decltype(f), double, 8>(f, d_prime);
}

}  // namespace palpate::analysis
