#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "sim/contact/exact/system.hpp"
#include "sim/contact/exact/updated_factor.hpp"

namespace palpate::sim {

/// How far the probes' forces can be from those of the exact solution, whatever has made the present forces.
///
/// Let lambda >= 0 be the contacts' forces, w their gaps, W the compliance of the contacts while the probes hold, and r
/// the change of the gaps that makes lambda exact: r_i = -w_i where lambda_i > 0, max(0, -w_i) elsewhere. The exact
/// lambda* obeys e^T (W e + r) <= 0 with e = lambda - lambda* (complementarity is monotone), so e lies in the ball of
/// W's norm about -W^-1 r / 2 with half of rho = ||r||_W^-1 as its radius. With c what the contacts do to the
/// force along an axis of a probe (or on a region that is held),
///   |F - F*| = |c^T e| <= (|c^T W^-1 r| + ||c||_W^-1 rho) / 2.
/// All norms are taken over the contacts that may be closed on the way from lambda to lambda*: those that are, and
/// those with w_j <= sqrt(W_jj) rho, for on that way no gap changes by more. Added are twice the first-order effect of
/// delta on the active set and of what rounding can have left in w.
class ForceBound {
 public:
  /// All storage is taken here. @param system  outlives the bound
  explicit ForceBound(const ContactSystem& system);

  /// @param factor   of the active rows, those that hold first; is as it was afterwards
  /// @param holding  how many rows hold
  /// @param forces   x of every row, the bilateral rows bring their values under them
  /// @param slack    w of every contact
  const ForceBound& find(UpdatedFactor& factor, std::size_t holding, const Eigen::VectorXd& forces,
                         const Eigen::VectorXd& slack);

  /// Of the forces of all probes [N].
  double largest() const;
  /// Whether each probe's bound is within a part of its force.
  bool within(double part, const Eigen::VectorXd& forces) const;

 private:
  void grow(UpdatedFactor& factor, std::size_t holding, const Eigen::VectorXd& forces,
            const Eigen::VectorXd& slack);
  void add(int probe, UpdatedFactor& factor, std::size_t holding, const Eigen::VectorXd& forces);
  double first_order(const UpdatedFactor& factor, std::size_t holding, const Eigen::VectorXd& forces);

  const ContactSystem* system_;
  std::vector<char> taken_;     // rows of the factor, while it is grown
  std::vector<double> change_;  // L^-1 r, in the factor's order
  std::vector<double>
      axis_;  // what a component of a force is made of, over the rows; then L^-1, L^-T of that
  std::vector<double> bounds_;  // of each probe [N]
  double rho_ = 0.0;
};

}  // namespace palpate::sim
