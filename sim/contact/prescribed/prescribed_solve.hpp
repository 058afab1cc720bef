#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "sim/model/free_state.hpp"
#include "sim/model/model.hpp"

namespace palpate::sim {

/// Forces that bring touched nodes to prescribed displacements while the pressing probes hold still: C_DD f_D
/// = u_D ([Hirota1998]), by a Cholesky factor whose leading rows are kept from cycle to cycle as long as they
/// ask for the same unknowns. A kept row has the bits that a fresh one would have, so no force depends on
/// what went before.
class PrescribedSolve {
 public:
  /// All storage is taken here, for the body's probes and so many nodes beside them.
  /// @param model  outlives the solve
  PrescribedSolve(const Model& model, int body, int most_nodes);

  /// @return false when a pivot of C_DD is not positive
  bool factor(const ProbeRows& probes, std::span<const int> nodes);

  /// Multipliers for E = 1 Pa, in the order of rows(): probe axes first, then x y z of each node.
  std::span<const double> solve(const ProbeRows* probe_values, std::span<const Vec3> node_values);

  int rows() const { return static_cast<int>(rows_.size()); }
  int probe_rows() const { return probe_rows_; }
  /// Adds the displacements that the multipliers of the last solve bring, for any E that scaled them away.
  void add_displacement(Eigen::VectorXd& displacement) const;
  /// What the multipliers of the last solve bring in the order of rows(), for E = 1 Pa: C_DD f_D.
  std::span<const double> brought();
  /// Adds E times the multipliers of the last solve as nodal forces [N].
  void add_forces(Eigen::VectorXd& forces) const;
  /// Force of probe `probe` on the body along its axes times E, in space [N].
  Vec3 probe_force(int probe) const;

 private:
  struct Row {
    int probe = -1;  // index into Model::probes, or -1
    int index = 0;   // probe: axis; node: unknown 3 i + component
    bool operator==(const Row&) const = default;
  };
  bool factor_rows(int first, int end);
  void substitute_forward(double* x) const;
  void substitute_backward(double* x) const;
  double entry(const Row& a, const Row& b) const;
  static std::ptrdiff_t begin_of(int i) { return static_cast<std::ptrdiff_t>(i) * (i + 1) / 2; }
  double* row(int i) { return factor_.data() + begin_of(i); }
  const double* row(int i) const { return factor_.data() + begin_of(i); }

  const Model* model_;
  const Body* body_;
  int most_rows_ = 0;
  int probe_rows_ = 0;
  int factored_ = 0;                   // leading rows of factor_ that hold
  const ProbeRows* probes_ = nullptr;  // of the last factor()
  std::vector<Row> rows_, wanted_;
  std::vector<double> factor_;          // lower triangle, one row after the other
  std::vector<double> matrix_;          // C_DD, lower triangle, one row after the other
  std::vector<double> inverse_pivots_;  // of factor_
  std::vector<double> multipliers_, brought_;
};

}  // namespace palpate::sim
