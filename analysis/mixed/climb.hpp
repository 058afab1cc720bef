#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "analysis/mixed/glmm.hpp"
#include "analysis/mixed/marginal.hpp"

namespace palpate::analysis {

/// Climbs to the maximum of a marginal likelihood in two stages: a quasi-Newton method (NLopt's L-BFGS) on
/// Laplace's approximation, then Newton steps on the likelihood that was asked for, whose curvature at the
/// end gives the standard errors. Parameters are unbounded: the likelihood is symmetric in the signs of
/// Lambda's columns, so a variance of 0 is an ordinary maximum.
template <int Q>
class Climb {
 public:
  using Marginal = MarginalLikelihood<Q>;
  using Parameters = typename Marginal::Parameters;
  static constexpr int kParameters = Marginal::kParameters;

  Climb(const Observations& data, const GlmmOptions& options);
  void run();

  const Parameters& at() const { return at_; }
  double log_likelihood() const { return value_; }
  bool singular() const { return singular_; }  // a variance is 0
  const Convergence& convergence() const { return convergence_; }
  const Eigen::Matrix2d& fixed_covariance() const { return fixed_covariance_; }  // NaN without convergence

 private:
  using Vector = Eigen::VectorXd;  // of the free parameters
  using Matrix = Eigen::MatrixXd;

  static double of_nlopt(const std::vector<double>& x, std::vector<double>& gradient, void* self);
  double evaluate(const Parameters& at, Parameters& gradient);
  void quasi_newton();
  void finish();
  void settle_on_boundary();
  void newton();
  bool step(const Matrix& covariance);
  Matrix information();
  Vector free_part(const Parameters& parameters) const;
  Parameters with_free_part(const Vector& values) const;
  void keep_covariance(const Matrix& covariance);

  const Observations* data_;
  GlmmOptions options_;
  Marginal marginal_;
  std::vector<int> free_{};  // parameters that are estimated; the others stay where they are
  Parameters at_ = Parameters::Zero(), gradient_ = Parameters::Zero();
  double value_ = 0.0;
  bool singular_ = false;
  Convergence convergence_{};
  Eigen::Matrix2d fixed_covariance_;
};

extern template class Climb<1>;
extern template class Climb<2>;

}  // namespace palpate::analysis
