#include "analysis/mixed/marginal.hpp"

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>

#include "analysis/mixed/examinee_integrand.hpp"
#include "analysis/mixed/gauss_hermite.hpp"
#include "analysis/numerics/infinity.hpp"

namespace palpate::analysis {
namespace {

// The lower triangle with half its diagonal: what the derivative of a Cholesky factor is made of.
template <int Q>
Eigen::Matrix<double, Q, Q> half_lower(const Eigen::Matrix<double, Q, Q>& square) {
  Eigen::Matrix<double, Q, Q> half = square.template triangularView<Eigen::Lower>();
  half.diagonal() /= 2;
  return half;
}

// Row and column of Lambda that parameter k (k >= 2) is.
struct Entry {
  int row, column;
};
constexpr Entry entry_of(int parameter) {
  constexpr Entry kEntries[] = {{0, 0}, {1, 0}, {1, 1}};
  return kEntries[parameter - 2];
}

// d eta_j/d parameter at fixed u is (1, x_j) c.
template <int Q>
Eigen::Vector2d direct(int parameter, const Eigen::Matrix<double, Q, 1>& u) {
  Eigen::Vector2d c = Eigen::Vector2d::Zero();
  if (parameter < 2) {
    c[parameter] = 1;
  } else {
    const Entry entry = entry_of(parameter);
    c[entry.row] = u[entry.column];
  }
  return c;
}

// How the mode and the scale of the nodes move with one parameter.
template <int Q>
struct Movement {
  Eigen::Matrix<double, Q, Q> factor;  // of L, L L' = H^-1
  Eigen::Matrix<double, Q, 1> mode;
  double log_determinant;  // of log det L
};

template <int Q>
Movement<Q> movement(const ExamineeIntegrand<Q>& integrand, const typename ExamineeIntegrand<Q>::Curved& at,
                     const Eigen::Matrix<double, Q, 1>& mode, const Eigen::Matrix<double, Q, Q>& inverse,
                     const Eigen::Matrix<double, Q, Q>& factor, int parameter) {
  using Effects = Eigen::Matrix<double, Q, 1>;
  using Square = Eigen::Matrix<double, Q, Q>;
  const auto& lambda = integrand.lambda;
  const Eigen::Vector2d c = direct<Q>(parameter, mode);
  Effects mixed = -lambda.transpose() * (at.moments() * c);  // d2 g/(du d parameter)
  Square change = Square::Zero();                            // of H
  if (parameter >= 2) {
    const Entry entry = entry_of(parameter);
    mixed[entry.column] += at.value.scores[entry.row];
    const Eigen::Matrix<double, 1, Q> row = at.moments().row(entry.row) * lambda;
    change.row(entry.column) += row;
    change.col(entry.column) += row.transpose();
  }
  const Effects mode_moves = inverse * mixed;
  const Eigen::Vector2d d = c + lambda * mode_moves;  // the whole change of eta_j is (1, x_j) d
  const double* t = at.w_slope;
  const Eigen::Matrix2d third = (Eigen::Matrix2d() << t[0] * d[0] + t[1] * d[1], t[1] * d[0] + t[2] * d[1],
                                 t[1] * d[0] + t[2] * d[1], t[2] * d[0] + t[3] * d[1])
                                    .finished();
  change += lambda.transpose() * third * lambda;
  const Square along = factor.transpose() * change * factor;
  return {
      .factor = -factor * half_lower<Q>(along), .mode = mode_moves, .log_determinant = -along.trace() / 2};
}

// The sum of exp(log) over nodes and its gradient, by exp(largest), so that nothing underflows.
template <typename Parameters>
struct NodeSum {
  double largest = -kInfinity, sum = 0.0;
  Parameters slopes = Parameters::Zero();

  void add(double log, const Parameters& log_slopes) {
    if (log > largest) {
      const double shrink = std::exp(largest - log);
      sum *= shrink, slopes *= shrink, largest = log;
    }
    const double weight = std::exp(log - largest);
    sum += weight;
    slopes += weight * log_slopes;
  }
};

}  // namespace

template <int Q>
MarginalLikelihood<Q>::MarginalLikelihood(const Observations& data, Link link, int nodes)
    : data_(&data), link_(link), modes_(data.examinees()) {
  const std::vector<QuadratureNode> rule = gauss_hermite(nodes);
  const auto log_weight = [](const QuadratureNode& node) {
    return std::log(node.weight) + node.t * node.t - std::log(std::numbers::pi) / 2;
  };
  for (const QuadratureNode& one : rule) {
    if constexpr (Q == 1) {
      nodes_.push_back({.t = Effects(one.t), .log_weight = log_weight(one)});
    } else {
      for (const QuadratureNode& other : rule) {
        nodes_.push_back({.t = Effects(one.t, other.t), .log_weight = log_weight(one) + log_weight(other)});
      }
    }
  }
}

template <int Q>
double MarginalLikelihood<Q>::add_examinee(std::size_t examinee, const Parameters& parameters,
                                           const Lambda& lambda, Parameters& gradient) {
  using Square = Eigen::Matrix<double, Q, Q>;
  const ExamineeIntegrand<Q> integrand{.data = *data_,
                                       .link = link_,
                                       .first = data_->first[examinee],
                                       .last = data_->first[examinee + 1],
                                       .beta = parameters.template head<2>(),
                                       .lambda = lambda};
  Mode& mode = modes_[examinee];
  mode.u += mode.moves * (parameters - last_);
  const auto at = integrand.climb(mode.u);
  const Square inverse = at.hessian(integrand).inverse();
  const Square factor = inverse.llt().matrixL();
  std::array<Movement<Q>, kParameters> moves;
  for (int p = 0; p < kParameters; ++p) {
    moves[p] = movement<Q>(integrand, at, mode.u, inverse, factor, p);
    mode.moves.col(p) = moves[p].mode;
  }
  NodeSum<Parameters> sum;
  for (const Node& node : nodes_) {
    const Effects u = mode.u + std::numbers::sqrt2 * (factor * node.t);
    const auto value = nodes_.size() == 1 ? at.value : integrand.value(u);
    const Effects pull = lambda.transpose() * value.scores - u;
    Parameters slopes;
    for (int p = 0; p < kParameters; ++p) {
      const Movement<Q>& move = moves[p];
      const Effects u_moves = move.mode + std::numbers::sqrt2 * (move.factor * node.t);
      slopes[p] = direct<Q>(p, u).dot(value.scores) + pull.dot(u_moves);
    }
    sum.add(value.g + node.log_weight, slopes);
  }
  for (int p = 0; p < kParameters; ++p) {
    gradient[p] += sum.slopes[p] / sum.sum + moves[p].log_determinant;
  }
  return sum.largest + std::log(sum.sum) + std::log(factor.determinant());
}

template <int Q>
double MarginalLikelihood<Q>::operator()(const Parameters& parameters, Parameters& gradient) {
  Lambda lambda = Lambda::Zero();
  for (int p = 2; p < kParameters; ++p) lambda(entry_of(p).row, entry_of(p).column) = parameters[p];
  gradient.setZero();
  double total = 0.0;
  for (std::size_t i = 0; i < data_->examinees(); ++i) total += add_examinee(i, parameters, lambda, gradient);
  last_ = parameters;
  return total;
}

template class MarginalLikelihood<1>;
template class MarginalLikelihood<2>;

}  // namespace palpate::analysis
