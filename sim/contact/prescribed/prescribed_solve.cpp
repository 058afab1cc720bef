#include "sim/contact/prescribed/prescribed_solve.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace palpate::sim {
namespace {

using RowMap = Eigen::Map<const Eigen::VectorXd>;

}  // namespace

PrescribedSolve::PrescribedSolve(const Model& model, int body, int most_nodes)
    : model_(&model), body_(&model.bodies[body]), most_rows_(3 * most_nodes) {
  for (const int probe : body_->probes) most_rows_ += static_cast<int>(model.probes[probe].axes.cols());
  const std::size_t size = most_rows_;
  rows_.reserve(size);
  wanted_.reserve(size);
  multipliers_.reserve(size);
  brought_.reserve(size);
  factor_.resize(size * (size + 1) / 2);
  matrix_.resize(factor_.size());
}

double PrescribedSolve::entry(const Row& a, const Row& b) const {
  if (a.probe < 0 && b.probe < 0) return body_->compliance->touch_touch(a.index, b.index);
  if (a.probe < 0) return entry(b, a);
  const Probe& pressing = model_->probes[a.probe];
  if (b.probe < 0) return pressing.compliance(b.index, a.index);
  const Probe& other = model_->probes[b.probe];
  double sum = 0.0;  // the other probe's weighted mean of what this probe's unit force does
  for (std::size_t i = 0; i < other.nodes.size(); ++i)
    sum += other.weights[i] *
           other.axes.col(b.index).dot(pressing.compliance.col(a.index).segment<3>(3 * other.nodes[i]));
  return sum;
}

bool PrescribedSolve::factor(const ProbeRows& probes, std::span<const int> nodes) {
  wanted_.clear();
  for (const int probe : body_->probes) {
    if (!probes[probe].pressing) continue;
    const auto axes = static_cast<int>(model_->probes[probe].axes.cols());
    for (int axis = 0; axis < axes; ++axis) wanted_.push_back({probe, axis});
  }
  probe_rows_ = static_cast<int>(wanted_.size());
  for (const int node : nodes)
    for (int component = 0; component < 3; ++component) wanted_.push_back({-1, 3 * node + component});
  assert(static_cast<int>(wanted_.size()) <= most_rows_);

  const auto differ = std::ranges::mismatch(wanted_, rows_).in1 - wanted_.begin();
  factored_ = std::min(factored_, static_cast<int>(differ));
  rows_.assign(wanted_.begin(), wanted_.end());
  for (int i = factored_; i < rows(); ++i) {
    double* const row_i = row(i);
    double* const matrix_i = matrix_.data() + begin_of(i);
    for (int j = 0; j <= i; ++j) {
      const double* const row_j = row(j);
      matrix_i[j] = entry(rows_[i], rows_[j]);
      const double rest = matrix_i[j] - RowMap(row_i, j).dot(RowMap(row_j, j));
      if (j < i)
        row_i[j] = rest / row_j[j];
      else if (rest > 0.0)
        row_i[i] = std::sqrt(rest);
      else
        return false;
    }
    factored_ = i + 1;
  }
  return true;
}

std::span<const double> PrescribedSolve::solve(const ProbeRows* probe_values,
                                               std::span<const Vec3> node_values) {
  multipliers_.clear();
  for (int i = 0; i < rows(); ++i) {
    const Row& wanted = rows_[i];
    if (wanted.probe < 0)
      multipliers_.push_back(node_values[wanted.index / 3][wanted.index % 3]);
    else
      multipliers_.push_back(probe_values ? (*probe_values)[wanted.probe].value[wanted.index] : 0.0);
  }
  Eigen::Map<Eigen::VectorXd> x(multipliers_.data(), rows());
  for (int i = 0; i < rows(); ++i) x[i] = (x[i] - RowMap(row(i), i).dot(x.head(i))) / row(i)[i];
  for (int i = rows() - 1; i >= 0; --i) {
    x[i] /= row(i)[i];
    x.head(i) -= x[i] * RowMap(row(i), i);
  }
  return multipliers_;
}

void PrescribedSolve::add_displacement(Eigen::VectorXd& displacement) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& wanted = rows_[i];
    if (wanted.probe < 0)
      displacement.noalias() += multipliers_[i] * body_->compliance->touch_touch.col(wanted.index);
    else
      displacement.noalias() += multipliers_[i] * model_->probes[wanted.probe].compliance.col(wanted.index);
  }
}

std::span<const double> PrescribedSolve::brought() {
  brought_.assign(rows_.size(), 0.0);
  const RowMap x(multipliers_.data(), rows());
  Eigen::Map<Eigen::VectorXd> y(brought_.data(), rows());
  for (int i = 0; i < rows(); ++i) {
    const RowMap row_i(matrix_.data() + begin_of(i), i + 1);
    y[i] += row_i.dot(x.head(i + 1));
    y.head(i) += x[i] * row_i.head(i);
  }
  return brought_;
}

void PrescribedSolve::add_forces(Eigen::VectorXd& forces) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& wanted = rows_[i];
    const double force = body_->young_modulus * multipliers_[i];
    if (wanted.probe < 0) {
      forces[wanted.index] += force;
      continue;
    }
    const Probe& probe = model_->probes[wanted.probe];
    for (std::size_t k = 0; k < probe.nodes.size(); ++k)
      forces.segment<3>(3 * probe.nodes[k]) += force * probe.weights[k] * probe.axes.col(wanted.index);
  }
}

Vec3 PrescribedSolve::probe_force(int probe) const {
  Vec3 force = Vec3::Zero();
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (rows_[i].probe == probe)
      force += body_->young_modulus * multipliers_[i] * model_->probes[probe].axes.col(rows_[i].index);
  return force;
}

}  // namespace palpate::sim
