#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "sim/contact/frictional/friction_system.hpp"

namespace palpate::sim {

/// How a solve of frictional contact ended.
struct CoulombReport {
  bool converged = false;  // false: the cap was reached; the forces lie in their cones all the same
  int iterations = 0;      // Newton steps and sweeps
  double residual = 0.0;   // see CoulombSolve
};

/// What a contact does.
enum class Touch : char { Open, Sticks, Slips };

/// The frictional contact of a cycle: find forces x with
///   (K x)_i = value_i of each probe's row that holds (x_i = 0 of the others), and for each contact with
///   w = g + K x (its gap, and how far its sides have slipped):  x_n >= 0, w_n >= 0, x_n w_n = 0,
///   |x_t| <= mu x_n, and x_t = -mu x_n w_t / |w_t| where w_t is not 0.
/// Semismooth Newton on x = P(x - w / D), P the projection on the half-line and on the disk of radius mu x_n
/// [AlartCurnier1991], begun at the last solve's forces; where it does not converge, sweeps of projected Gauss-Seidel
/// bring it nearer and it begins again. Residual: the largest component of x - P(x - w / D) over the largest force.
class CoulombSolve {
 public:
  static constexpr int kMostIterations = 400;

  /// All storage is taken here. @param system  outlives the solve
  explicit CoulombSolve(const FrictionSystem& system);

  /// @param holds, values  of each row of a probe
  /// @param gaps  g of each contact, three numbers in its frame [m]
  /// @param near  the contacts that can touch; the others carry nothing
  CoulombReport solve(double friction, std::span<const char> holds, std::span<const double> values,
                      std::span<const Vec3> gaps, std::span<const int> near);

  const Eigen::VectorXd& forces() const { return forces_; }  // x [N]
  const Eigen::VectorXd& slack() const { return slack_; }    // w of the near contacts [m]
  Touch touch(int contact) const { return touch_[static_cast<std::size_t>(contact)]; }

  /// Of the rows that hold, the forces that bring `values` without any contact; in place, one number a row.
  void solve_bilateral(std::span<const char> holds, std::span<double> values);

  /// Forgets the last solve's forces.
  void reset() { forces_.setZero(); }

 private:
  Eigen::Index row_of(int contact) const { return system_->bilateral + 3 * contact; }
  void classify(double friction, std::span<const int> near);
  bool newton_step(double friction, std::span<const char> holds, std::span<const double> values,
                   std::span<const Vec3> gaps, std::span<const int> near);
  void write_contact(double friction, int contact, std::span<const Vec3> gaps, Eigen::Index& equation);
  void sweep(double friction, std::span<const char> holds, std::span<const double> values,
             std::span<const Vec3> gaps, std::span<const int> near);
  void find_slack(std::span<const Vec3> gaps, std::span<const int> near);
  double residual(double friction, std::span<const int> near) const;
  Vec3 projected(double friction, int contact) const;

  const FrictionSystem* system_;
  Eigen::VectorXd forces_, slack_;
  std::vector<Touch> touch_;
  std::vector<Eigen::Vector2d> slips_;  // direction of the friction of a contact that slips
  std::vector<double> shrink_;          // how much of z the disk leaves there
  std::vector<Eigen::Index> unknowns_;  // rows of K that are solved for
  std::vector<double> matrix_;          // of a Newton step, row by row
  std::vector<double> right_;
};

}  // namespace palpate::sim
