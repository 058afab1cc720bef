#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "sim/contact/exact/updated_factor.hpp"

namespace palpate::sim {

/// Contacts and probes of a scene as one system, constant while it runs: x are forces, K x the displacements along
/// the rows that they bring.
struct ContactSystem {
  Eigen::MatrixXd compliance{};  // K [m/N], symmetric, positive semidefinite; bilateral rows first
  Eigen::Index bilateral = 0;    // how many of them: the axes of probes
};

/// How a solve ended.
struct ComplementarityReport {
  bool converged = false;  // false: the cap was reached, and forces that would pull are 0
  int iterations = 0;      // solves with a set of active contacts
  double residual = 0.0;   // scaled natural residual, see ComplementaritySolve
};

/// The frictionless contact of a cycle, a linear complementarity problem: find forces x with
///   (K x)_i = value_i                      of each bilateral row that holds (x_i = 0 of the others),
///   x_i >= 0, w_i = gap_i + (K x)_i >= 0, x_i w_i = 0   of each contact.
/// Block principal pivoting over sets of active contacts, begun at the last solve's set, with single pivots where the
/// number of wrong signs does not fall [JudicePires1994], which is finite. On the active set K has delta = 1e-12 of
/// its diagonal added, so that contacts that say the same share their force in one way. Residual: the largest of
/// |x - max(0, x - w/D)| over the contacts, D = diag K, divided by the largest x of a contact.
class ComplementaritySolve {
 public:
  static constexpr int kMostIterations = 1000;

  /// All storage is taken here. @param system  outlives the solve
  explicit ComplementaritySolve(const ContactSystem& system);

  /// @param holds   of each bilateral row, whether it prescribes its value
  /// @param values  of each bilateral row [m]
  /// @param gaps    of each contact before any force [m]
  ComplementarityReport solve(std::span<const char> holds, std::span<const double> values,
                              std::span<const double> gaps);

  const Eigen::VectorXd& forces() const { return forces_; }  // x, of every row [N]
  std::span<const int> active() const {
    return factor_.rows();
  }  // rows that hold or touch; bilateral ones first

  /// Of the bilateral rows that hold, the forces that bring their values without any contact [N]; in place, in the
  /// order of active(). To be asked after solve().
  void solve_bilateral(std::span<double> values) const { factor_.solve_leading(values, holding_); }
  std::size_t holding() const { return holding_; }

  /// Forgets the last solve's set.
  void reset();

 private:
  void hold(std::span<const char> holds);
  void solve_active(std::span<const double> values, std::span<const double> gaps);
  std::size_t count_wrong();
  void exchange(bool all);
  double natural_residual() const;
  Eigen::Index contact_of(int row) const { return row - system_->bilateral; }

  const ContactSystem* system_;
  UpdatedFactor factor_;
  std::size_t holding_ = 0;
  std::vector<char> is_active_;  // of each row
  std::vector<int> wrong_;       // rows whose sign is wrong, ascending
  std::vector<int> kept_;
  std::vector<double> correction_;
  Eigen::VectorXd forces_;  // x
  Eigen::VectorXd slack_;   // w of contacts; K x less the value of bilateral rows [m]
};

}  // namespace palpate::sim
