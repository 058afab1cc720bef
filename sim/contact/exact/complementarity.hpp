#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "sim/contact/exact/force_bound.hpp"
#include "sim/contact/exact/system.hpp"
#include "sim/contact/exact/updated_factor.hpp"

namespace palpate::sim {

/// How a solve ended.
struct ComplementarityReport {
  enum class End {
    Converged,
    WithinTolerance,
    CapReached
  } end = End::CapReached;  // but at the first, forces
                            // that would pull are 0
  int iterations = 0;       // solves with a set of active contacts
  double residual = 0.0;    // scaled natural residual, see ComplementaritySolve
  double force_error_bound =
      0.0;  // of the force of each probe against the exact solution [N], see ForceBound
};

/// The frictionless contact of a cycle, a linear complementarity problem: find forces x with
///   (K x)_i = value_i                      of each bilateral row that holds (x_i = 0 of the others),
///   x_i >= 0, w_i = gap_i + (K x)_i >= 0, x_i w_i = 0   of each contact.
/// Block principal pivoting over sets of active contacts, begun at the last solve's set, with single pivots where the
/// number of wrong signs does not fall [JudicePires1994], which is finite. On the active set K has delta = 1e-12 of
/// its diagonal added, so that contacts that say the same share their force in one way. Residual: the largest of
/// |x - max(0, x - w/D)| over the contacts, D = diag K, divided by the largest x of a contact. The last contacts whose
/// gap is larger than all forces together can have closed it by (gap_i > reach_i sum |x|) are open for certain, and left
/// out of the sums of K: contacts that are far come last.
class ComplementaritySolve {
 public:
  static constexpr int kMostIterations = 1000;

  /// All storage is taken here. @param system  outlives the solve
  explicit ComplementaritySolve(const ContactSystem& system);

  /// @param holds   of each bilateral row, whether it prescribes its value
  /// @param values  of each bilateral row [m]
  /// @param gaps    of each contact before any force [m]
  /// @param tolerance  of each probe's force: it may stop as soon as the bound of the error is within that part of it
  ComplementarityReport solve(std::span<const char> holds, std::span<const double> values,
                              std::span<const double> gaps, double tolerance = 0.0);

  const Eigen::VectorXd& forces() const { return forces_; }  // x, of every row [N]
  std::span<const int> active() const {
    return factor_.rows();
  }  // rows that hold or touch; bilateral ones first

  /// Of the bilateral rows that hold, the forces that bring their values without any contact [N]; in place, in the
  /// order of active(). To be asked after solve().
  void solve_bilateral(std::span<double> values) const { factor_.solve_leading(values, holding_); }
  std::size_t holding() const { return holding_; }
  /// Rows whose gaps the last solve has summed up; the others, the last ones, are open for certain.
  Eigen::Index looked_at() const { return looked_at_; }

  /// The system's matrix is another one than at the last solve.
  void changed() { changed_ = true; }

  /// Forgets the last solve's set.
  void reset();

 private:
  void hold(std::span<const char> holds);
  void solve_active(std::span<const double> values, std::span<const double> gaps);
  std::size_t count_wrong();
  void exchange(bool all);
  void settle(std::span<const double> values, std::span<const double> gaps);
  void begin_slack(std::span<const double> values, std::span<const double> gaps);
  void look_at_what_can_close(std::span<const double> gaps);
  void add_column(int row, double force);
  double natural_residual() const;
  const ContactSystem* system_;
  UpdatedFactor factor_;
  ForceBound bound_;
  std::size_t holding_ = 0;
  bool changed_ = false;
  std::vector<char> is_active_;  // of each row
  std::vector<int> wrong_;       // rows whose sign is wrong, ascending
  std::vector<int> kept_;
  std::vector<double> correction_;
  Eigen::VectorXd forces_;  // x
  Eigen::VectorXd
      slack_;  // w of contacts (of those that are left out, a lower bound > 0); K x less the value of
               // bilateral rows [m]
  Eigen::Index looked_at_ = 0;  // rows that are not left out, the first ones
};

}  // namespace palpate::sim
