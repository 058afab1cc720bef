#pragma once

#include <Eigen/Core>
#include <vector>

namespace palpate::sim {

/// What a force of 1 N of each row takes off the force that holds a region, or gives to a fingertip: rows x 3.
struct RegionPull {
  int probe = 0;
  Eigen::MatrixXd rows{};
};

/// Contacts and probes of a scene as one system: x are forces, K x the displacements along the rows that they bring.
struct ContactSystem {
  Eigen::MatrixXd compliance{};  // K [m/N], symmetric, positive semidefinite; bilateral rows first
  Eigen::Index bilateral = 0;    // how many of them: the axes of probes
  std::vector<Eigen::Index>
      first_of_probe{};  // where each probe's rows begin, and the end: one more than probes
  std::vector<RegionPull> regions{};

  /// Of each contact, the most that a newton of any row opens or closes it: the largest |K_ij| of its row [m/N]. Empty
  /// where rows are made anew from cycle to cycle.
  std::vector<double> reach{};
  /// K in single precision, where gaps are to be reckoned with it: half as much to read. Empty: with K itself.
  Eigen::MatrixXf single{};
};

/// Part of K's diagonal that is added on the active set, so that contacts that say the same share their force in one
/// way.
inline constexpr double kDelta = 1e-12;

}  // namespace palpate::sim
