#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/model/model.hpp"

namespace palpate::sim {

/// How far a press is taken, and how finely.
struct PressPlan {
  double depth = 0.0;        // of the deepest pose [m], > 0
  int steps = 50;            // of the force curve, equal ones
  double small_step = 1e-6;  // between the poses that jumps are looked for at [m]
};

/// What one variant makes of a press, apart from its time.
struct PressAccuracy {
  std::vector<double> forces{};  // on the first probe against its direction, at each step [N]
  double penetration = 0.0;      // deepest overlap that is left at any step [m]
  double imbalance = 0.0;  // largest |f_A + f_B| of the larger of the two, over steps and pairs of bodies [-]
  double largest_jump = 0.0;       // of the force between two poses that are a small step apart [N]
  double force_error_bound = 0.0;  // largest of any step [N]; infinite where one has none
  int unsolved = 0;                // steps, small ones too, that were not solved: their force counts as 0
  std::vector<Eigen::VectorXd> displacement{};  // of the touchable nodes of each body at the deepest pose [m]
};

PressAccuracy measure_accuracy(const Model& model, const PressPlan& plan);

/// Size of the triangles that may be touched: root of their mean area, over all bodies [m].
double edge_of(const Model& model);

/// How much the touched surfaces' displacement differs from a finer model's at the same places: root of the sum of the
/// squares over nodes, relative to that of the finer one's [-]. Places are matched at rest, by the nearest polygon.
double displacement_error(const Model& model, const std::vector<Eigen::VectorXd>& displacement,
                          const Model& finer, const std::vector<Eigen::VectorXd>& finer_displacement);

}  // namespace palpate::sim
