#include "analysis/mixed/climb.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <nlopt.hpp>
#include <stdexcept>

namespace palpate::analysis {
namespace {

// Log-likelihood that a last Newton step may still gain: estimates are within 1e-4 standard errors before it,
// and far nearer after it.
constexpr double kRemaining = 1e-8;

}  // namespace

template <int Q>
Climb<Q>::Climb(const Observations& data, const GlmmOptions& options)
    : data_(&data), options_(options), marginal_(data, options.link, 1) {
  fixed_covariance_.setConstant(std::numeric_limits<double>::quiet_NaN());
  for (int k = 0; k < kParameters; ++k) {
    if (k != 1 || options.with_slope) free_.push_back(k);
  }
  const double share = static_cast<double>(data.total_ones) / static_cast<double>(data.total_trials);
  at_[0] = quantile_of(options.link, share);
  at_[2] = 0.5;  // what people differ by on the predictor's scale, to an order of magnitude
  if constexpr (Q == 2) at_[4] = 0.5;
}

template <int Q>
void Climb<Q>::run() {
  quasi_newton();
  if (options_.nodes > 1) marginal_ = Marginal(*data_, options_.link, options_.nodes);
  finish();
  if (convergence_.converged || options_.nodes == 1) return;
  quasi_newton();  // now on the likelihood itself: Laplace's maximum was too far from its own
  finish();
}

template <int Q>
void Climb<Q>::finish() {
  value_ = evaluate(at_, gradient_);
  settle_on_boundary();
  newton();
}

template <int Q>
double Climb<Q>::evaluate(const Parameters& at, Parameters& gradient) {
  ++convergence_.evaluations;
  return marginal_(at, gradient);
}

template <int Q>
auto Climb<Q>::free_part(const Parameters& parameters) const -> Vector {
  Vector part(static_cast<Eigen::Index>(free_.size()));
  for (Eigen::Index k = 0; k < part.size(); ++k) part[k] = parameters[free_[k]];
  return part;
}

template <int Q>
auto Climb<Q>::with_free_part(const Vector& values) const -> Parameters {
  Parameters parameters = at_;
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    parameters[free_[k]] = values[k];
  }
  return parameters;
}

// The log-likelihood per answer: its curvature is of order 1, and so is L-BFGS's first step.
template <int Q>
double Climb<Q>::of_nlopt(const std::vector<double>& x, std::vector<double>& gradient, void* self) {
  auto& climb = *static_cast<Climb*>(self);
  Parameters slopes;
  const Eigen::Map<const Vector> values(x.data(), static_cast<Eigen::Index>(x.size()));
  const double value = climb.evaluate(climb.with_free_part(values), slopes);
  const double answers = static_cast<double>(climb.data_->total_trials);
  if (!gradient.empty()) {
    Eigen::Map<Vector>(gradient.data(), values.size()) = climb.free_part(slopes) / answers;
  }
  return value / answers;
}

template <int Q>
void Climb<Q>::quasi_newton() {
  nlopt::opt climber(nlopt::LD_LBFGS, static_cast<unsigned>(free_.size()));
  climber.set_max_objective(of_nlopt, this);
  climber.set_ftol_abs(kRemaining / 10 / static_cast<double>(data_->total_trials));
  climber.set_maxeval(1000);
  const Vector start = free_part(at_);
  std::vector<double> x(start.data(), start.data() + start.size());
  double value = 0.0;
  try {
    climber.optimize(x, value);
  } catch (const std::runtime_error&) {
    // It stopped where round-off stops it; newton() judges the place.
  }
  at_ = with_free_part(Eigen::Map<const Vector>(x.data(), start.size()));
}

// A column of Lambda that is 0 but for what the climb left over becomes 0 and is no longer free.
template <int Q>
void Climb<Q>::settle_on_boundary() {
  constexpr double kSmall = 1e-2, kLoss = 1e-6;  // on the predictor's scale; log-likelihood
  const auto settle = [&](const Parameters& settled, std::initializer_list<int> held) {
    Parameters gradient;
    const double value = evaluate(settled, gradient);
    if (!(value >= value_ - kLoss)) return;
    at_ = settled, value_ = value, gradient_ = gradient, singular_ = true;
    for (const int k : held) std::erase(free_, k);
  };
  Parameters settled = at_;
  if (std::abs(at_[2]) < kSmall) {
    settled[2] = 0;
    if constexpr (Q == 2) {  // then both others are the slope's alone, and one of them can say it
      settled[3] = 0, settled[4] = std::hypot(at_[3], at_[4]);
      settle(settled, {2, 3});
    } else {
      settle(settled, {2});
    }
  }
  if constexpr (Q == 2) {
    settled = at_;
    settled[4] = 0;
    if (std::abs(at_[4]) < kSmall) settle(settled, {4});
  }
}

// -d2 log-likelihood by central differences of the gradient.
template <int Q>
auto Climb<Q>::information() -> Matrix {
  constexpr double kStep = 1e-4;  // errors about 1e-8 of the whole
  const auto n = static_cast<Eigen::Index>(free_.size());
  Matrix matrix(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const int parameter = free_[k];
    Parameters up = at_, down = at_, slopes_up, slopes_down;
    up[parameter] += kStep, down[parameter] -= kStep;
    evaluate(up, slopes_up), evaluate(down, slopes_down);
    matrix.col(k) = free_part(slopes_down - slopes_up) / (2 * kStep);
  }
  return (matrix + matrix.transpose()) / 2;
}

// One Newton step, halved while it lowers the likelihood; false where it cannot climb.
template <int Q>
bool Climb<Q>::step(const Matrix& covariance) {
  constexpr double kRoundOff = 1e-10;
  const Vector slopes = free_part(gradient_);
  Vector move = covariance * slopes;
  convergence_.remaining = slopes.dot(move) / 2;
  for (int halvings = 0; halvings < 20; ++halvings, move /= 2) {
    Parameters gradient;
    const Parameters next = with_free_part(free_part(at_) + move);
    const double value = evaluate(next, gradient);
    if (value < value_ - kRoundOff || !std::isfinite(value)) continue;
    at_ = next, value_ = value, gradient_ = gradient;
    return true;
  }
  return false;
}

template <int Q>
void Climb<Q>::newton() {
  constexpr int kMostCurvatures = 10, kMostSteps = 5;  // steps with one curvature: they close in fast enough
  for (int curvatures = 0; curvatures < kMostCurvatures; ++curvatures) {
    const Eigen::LDLT<Matrix> factor(information());
    if (factor.info() != Eigen::Success || !factor.isPositive() || factor.rcond() < 1e-12) {
      convergence_.reason = "the likelihood has no maximum here: its curvature is not negative definite";
      return;
    }
    const auto n = static_cast<Eigen::Index>(free_.size());
    const Matrix covariance = factor.solve(Matrix::Identity(n, n));
    double first = 0.0;
    for (int steps = 0; steps < kMostSteps; ++steps) {
      if (!step(covariance)) {
        convergence_.reason = "Newton's steps do not climb";
        return;
      }
      if (steps == 0) first = convergence_.remaining;
      if (convergence_.remaining < kRemaining) break;
    }
    if (first < 100 * kRemaining && convergence_.remaining < kRemaining) {  // the curvature is the maximum's
      convergence_.converged = true;
      convergence_.reason = "Newton's steps gain nothing and the curvature is negative definite";
      keep_covariance(covariance);
      return;
    }
  }
  convergence_.reason = "Newton's steps do not settle";
}

template <int Q>
void Climb<Q>::keep_covariance(const Matrix& covariance) {
  fixed_covariance_.setZero();
  for (std::size_t i = 0; i < free_.size(); ++i) {
    for (std::size_t k = 0; k < free_.size(); ++k) {
      if (free_[i] > 1 || free_[k] > 1) continue;
      fixed_covariance_(free_[i], free_[k]) =
          covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k));
    }
  }
}

template class Climb<1>;
template class Climb<2>;

}  // namespace palpate::analysis
