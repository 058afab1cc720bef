#pragma once

#include <Eigen/Dense>
#include <cstddef>

#include "analysis/mixed/link.hpp"
#include "analysis/mixed/observations.hpp"

namespace palpate::analysis {

/// What one examinee adds to the likelihood, before the random effects are integrated out:
///   g(u) = sum_j log p(answers_j; eta_j) - u'u/2,  eta_j = (1, x_j)(beta + Lambda u).
/// All that its derivatives need of the answers are sums over rows, weighted by powers of x.
template <int Q>
struct ExamineeIntegrand {
  using Effects = Eigen::Matrix<double, Q, 1>;
  using Square = Eigen::Matrix<double, Q, Q>;

  const Observations& data;
  Link link;
  std::size_t first, last;  // rows of the examinee
  Eigen::Vector2d beta;
  Eigen::Matrix<double, 2, Q> lambda;  // zero row below for Q = 1

  struct Value {
    double g = 0.0;
    Eigen::Vector2d scores{0, 0};  // sum s_j (1, x_j)
  };
  struct Curved {
    Value value{};
    double w[3] = {0, 0, 0};           // sum w_j x_j^k
    double w_slope[4] = {0, 0, 0, 0};  // sum dw_j/deta x_j^k

    Effects gradient(const ExamineeIntegrand& of, const Effects& u) const {
      return of.lambda.transpose() * value.scores - u;
    }
    Eigen::Matrix2d moments() const { return (Eigen::Matrix2d() << w[0], w[1], w[1], w[2]).finished(); }
    Square hessian(const ExamineeIntegrand& of) const {  // of -g
      return of.lambda.transpose() * moments() * of.lambda + Square::Identity();
    }
  };

  Value value(const Effects& u) const {
    Value sum{.g = -u.squaredNorm() / 2};
    const Eigen::Vector2d line = beta + lambda * u;
    for (std::size_t j = first; j < last; ++j) {
      const BinaryLikelihood at =
          likelihood(link, line[0] + line[1] * data.x[j], data.ones[j], data.trials[j]);
      sum.g += at.log;
      sum.scores[0] += at.score;
      sum.scores[1] += at.score * data.x[j];
    }
    return sum;
  }

  Curved curved(const Effects& u) const {
    Curved sum{.value = {.g = -u.squaredNorm() / 2}};
    const Eigen::Vector2d line = beta + lambda * u;
    for (std::size_t j = first; j < last; ++j) {
      const double x = data.x[j];
      const BinaryLikelihood at = likelihood(link, line[0] + line[1] * x, data.ones[j], data.trials[j]);
      sum.value.g += at.log;
      sum.value.scores[0] += at.score;
      sum.value.scores[1] += at.score * x;
      double power = 1;
      for (int k = 0; k < 4; ++k, power *= x) {
        if (k < 3) sum.w[k] += at.curvature * power;
        sum.w_slope[k] += at.curvature_slope * power;
      }
    }
    return sum;
  }

  /// Newton's method from u, which becomes the mode; g is strictly concave. Steps that lower g are halved.
  Curved climb(Effects& u) const {
    constexpr int kMostSteps = 100;
    constexpr double kSmallStep = 1e-6;  // the error after it is its square
    Curved here = curved(u);
    for (int k = 0; k < kMostSteps; ++k) {
      Effects step = here.hessian(*this).llt().solve(here.gradient(*this, u));
      const bool last_step = step.norm() < kSmallStep * (1 + u.norm());
      Curved next = curved(u + step);
      for (int halvings = 0; next.value.g < here.value.g && !last_step && halvings < 50; ++halvings) {
        step /= 2;
        next = curved(u + step);
      }
      u += step;
      here = next;
      if (last_step) break;
    }
    return here;
  }
};

}  // namespace palpate::analysis
