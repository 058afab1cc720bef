#include "sim/contact/exact/contact_system.hpp"

#include <vector>

namespace palpate::sim {
namespace {

/// What a row of the system measures of one body: weights on its touchable unknowns (J^T of one row).
struct RowOnBody {
  int row = 0;
  std::vector<int> nodes{};
  std::vector<Vec3> weights{};
};

double measure(const RowOnBody& row, Eigen::Ref<const Eigen::VectorXd> displacement) {
  double sum = 0.0;
  for (std::size_t i = 0; i < row.nodes.size(); ++i)
    sum += row.weights[i].dot(displacement.segment<3>(3 * row.nodes[i]));
  return sum;
}

std::vector<RowOnBody> rows_on_body(const Model& model, int body, std::span<const FacingPair> pairs) {
  std::vector<RowOnBody> rows;
  int row = 0;
  for (const Probe& probe : model.probes)
    for (Eigen::Index axis = 0; axis < probe.axes.cols(); ++axis, ++row) {
      if (probe.body != body) continue;
      RowOnBody held{.row = row, .nodes = probe.nodes};
      for (const double weight : probe.weights) held.weights.emplace_back(weight * probe.axes.col(axis));
      rows.push_back(std::move(held));
    }
  for (const FacingPair& pair : pairs) {
    if (pair.node_body == body) rows.push_back({row, {pair.node}, {pair.normal}});
    if (pair.polygon_body == body) {
      RowOnBody polygon{.row = row, .nodes = {pair.corners.begin(), pair.corners.end()}};
      for (const double weight : pair.weights) polygon.weights.emplace_back(-weight * pair.normal);
      rows.push_back(std::move(polygon));
    }
    ++row;
  }
  return rows;
}

std::vector<Eigen::Index> first_rows_of_probes(const Model& model) {
  std::vector<Eigen::Index> first{0};
  for (const Probe& probe : model.probes) first.push_back(first.back() + probe.axes.cols());
  return first;
}

/// J C J^T / E of one body.
void add_body(const Model& model, int index, std::span<const FacingPair> pairs, Eigen::MatrixXd& compliance) {
  const Body& body = model.bodies[index];
  const std::vector<RowOnBody> rows = rows_on_body(model, index, pairs);
  Eigen::VectorXd moved(body.compliance->touch_touch.rows());
  for (const RowOnBody& from : rows) {
    moved.setZero();
    for (std::size_t i = 0; i < from.nodes.size(); ++i)
      for (int k = 0; k < 3; ++k)
        moved +=
            from.weights[i][k] / body.young_modulus * body.compliance->touch_touch.col(3 * from.nodes[i] + k);
    for (const RowOnBody& to : rows) compliance(to.row, from.row) += measure(to, moved);
  }
}

}  // namespace

ContactSystem contact_system(const Model& model, std::span<const FacingPair> pairs) {
  std::vector<Eigen::Index> first = first_rows_of_probes(model);
  const Eigen::Index size = first.back() + std::ssize(pairs);
  ContactSystem system{.compliance = Eigen::MatrixXd::Zero(size, size),
                       .bilateral = first.back(),
                       .first_of_probe = std::move(first)};
  for (int body = 0; body < std::ssize(model.bodies); ++body) add_body(model, body, pairs, system.compliance);
  const Eigen::MatrixXd transposed = system.compliance.transpose();
  system.compliance = 0.5 * (system.compliance + transposed);
  return system;
}

}  // namespace palpate::sim
