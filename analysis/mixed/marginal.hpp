#pragma once

#include <Eigen/Core>
#include <vector>

#include "analysis/mixed/link.hpp"
#include "analysis/mixed/observations.hpp"

namespace palpate::analysis {

/// The likelihood of a generalised linear mixed model with the random effects integrated out:
///   eta_j = (1, x_j) beta + (1, x_j)_Q Lambda u,  u ~ N(0, I),
/// with Q = 1 (random intercept) or 2 (random intercept and slope), and Lambda lower triangular. The integral
/// over each examinee's u is done by adaptive Gauss-Hermite quadrature about the mode of the integrand,
/// scaled by the curvature there [PinheiroBates1995]; a product rule for Q = 2. One node is Laplace's
/// approximation. parameters: beta_0, beta_1, then Lambda by columns (1 or 3), for the standardised level.
template <int Q>
class MarginalLikelihood {
 public:
  static constexpr int kParameters = 2 + Q * (Q + 1) / 2;
  using Parameters = Eigen::Matrix<double, kParameters, 1>;

  MarginalLikelihood(const Observations& data, Link link, int nodes);

  /// The log-likelihood without Observations::log_ways, and its gradient: exact for the rule, the movement of
  /// the nodes included. Keeps the modes, from which the next call starts; that changes no more than
  /// round-off.
  double operator()(const Parameters& parameters, Parameters& gradient);

 private:
  using Effects = Eigen::Matrix<double, Q, 1>;
  using Lambda = Eigen::Matrix<double, 2, Q>;  // zero row below for Q = 1
  struct Node {
    Effects t{};
    double log_weight = 0.0;  // of exp(t't) f(t), by pi^(-Q/2)
  };
  struct Mode {
    Effects u = Effects::Zero();
    Eigen::Matrix<double, Q, kParameters> moves = decltype(moves)::Zero();  // du/dparameters
  };

  double add_examinee(std::size_t examinee, const Parameters& parameters, const Lambda& lambda,
                      Parameters& gradient);

  const Observations* data_;
  Link link_;
  std::vector<Node> nodes_{};
  std::vector<Mode> modes_{};             // one an examinee
  Parameters last_ = Parameters::Zero();  // to which the modes belong
};

extern template class MarginalLikelihood<1>;
extern template class MarginalLikelihood<2>;

}  // namespace palpate::analysis
