#include "sim/contact/prescribed/prescribed_solve.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace palpate::sim {
namespace {

using RowMap = Eigen::Map<const Eigen::VectorXd>;

constexpr int kRowsAtOnce = 4;  // whose sums are independent, so that the processor need not wait for each

}  // namespace

PrescribedSolve::PrescribedSolve(const Model& model, int body, int most_nodes)
    : model_(&model), body_(&model.bodies[body]), most_rows_(3 * most_nodes) {
  for (const int probe : body_->probes) most_rows_ += static_cast<int>(model.probes[probe].axes.cols());
  const std::size_t size = most_rows_;
  rows_.reserve(size);
  wanted_.reserve(size);
  multipliers_.reserve(size);
  brought_.reserve(size);
  inverse_pivots_.resize(size);
  factor_.resize(size * (size + 1) / 2);
  matrix_.resize(factor_.size());
}

double PrescribedSolve::entry(const Row& a, const Row& b) const {
  if (a.probe < 0 && b.probe < 0) return body_->compliance->touch_touch(a.index, b.index);
  if (a.probe < 0) return entry(b, a);
  const Eigen::MatrixXd& pressing = compliance_of(model_->probes[a.probe], (*probes_)[a.probe]);
  if (b.probe < 0) return pressing(b.index, a.index);
  const Probe& other = model_->probes[b.probe];
  const std::span<const double> weights = weights_of(other, (*probes_)[b.probe]);
  double sum = 0.0;  // the other probe's weighted mean of what this probe's unit force does
  for (std::size_t i = 0; i < other.nodes.size(); ++i)
    sum += weights[i] * other.axes.col(b.index).dot(pressing.col(a.index).segment<3>(3 * other.nodes[i]));
  return sum;
}

// Column by column, so that no row waits for the other rows' last entries.
bool PrescribedSolve::factor_rows(int first, int end) {
  for (int j = 0; j < end; ++j) {
    const double* const row_j = row(j);
    for (int i = std::max(first, j); i < end; ++i) {
      double* const row_i = row(i);
      const double c = entry(rows_[i], rows_[j]);
      matrix_[begin_of(i) + j] = c;
      const double rest = c - RowMap(row_i, j).dot(RowMap(row_j, j));
      if (j < i)
        row_i[j] = rest * inverse_pivots_[j];
      else if (rest > 0.0)
        inverse_pivots_[i] = 1.0 / (row_i[i] = std::sqrt(rest));
      else
        return false;
    }
  }
  factored_ = end;
  return true;
}

bool PrescribedSolve::factor(const ProbeRows& probes, std::span<const int> nodes) {
  probes_ = &probes;
  wanted_.clear();
  for (const int probe : body_->probes) {
    if (!probes[probe].pressing) continue;
    if (!model_->probes[probe].slide.knots.empty()) factored_ = 0;  // its rows are others wherever it is
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
  for (int first = factored_; first < rows(); first = factored_)
    if (!factor_rows(first, std::min(first + kRowsAtOnce, rows()))) return false;
  return true;
}

// x := L^-1 x: of some rows at once what the entries before them take, then what they take of each other.
void PrescribedSolve::substitute_forward(double* x) const {
  for (int first = 0; first < rows(); first += kRowsAtOnce) {
    const int count = std::min(kRowsAtOnce, rows() - first);
    std::array<double, kRowsAtOnce> here{};
    for (int i = 0; i < count; ++i)
      here[i] = x[first + i] - RowMap(row(first + i), first).dot(RowMap(x, first));
    for (int i = 0; i < count; ++i) {
      const double* const row_i = row(first + i) + first;
      for (int j = 0; j < i; ++j) here[i] -= row_i[j] * here[j];
      x[first + i] = here[i] *= inverse_pivots_[first + i];
    }
  }
}

// x := L^-T x, the same way from the end.
void PrescribedSolve::substitute_backward(double* x) const {
  for (int end = rows(); end > 0;) {
    const int first = (end - 1) / kRowsAtOnce * kRowsAtOnce, count = end - first;
    std::array<double, kRowsAtOnce> here{};
    for (int i = 0; i < count; ++i) here[i] = x[first + i];
    for (int i = count - 1; i >= 0; --i) {
      const double* const row_i = row(first + i) + first;
      x[first + i] = here[i] *= inverse_pivots_[first + i];
      for (int j = 0; j < i; ++j) here[j] -= here[i] * row_i[j];
    }
    Eigen::Map<Eigen::VectorXd> before(x, first);
    if (count == kRowsAtOnce)
      before -= here[0] * RowMap(row(first), first) + here[1] * RowMap(row(first + 1), first) +
                here[2] * RowMap(row(first + 2), first) + here[3] * RowMap(row(first + 3), first);
    else
      for (int i = 0; i < count; ++i) before -= here[i] * RowMap(row(first + i), first);
    end = first;
  }
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
  substitute_forward(multipliers_.data());
  substitute_backward(multipliers_.data());
  return multipliers_;
}

void PrescribedSolve::add_displacement(Eigen::VectorXd& displacement) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& wanted = rows_[i];
    if (wanted.probe < 0)
      displacement.noalias() += multipliers_[i] * body_->compliance->touch_touch.col(wanted.index);
    else
      displacement.noalias() +=
          multipliers_[i] *
          compliance_of(model_->probes[wanted.probe], (*probes_)[wanted.probe]).col(wanted.index);
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
    const std::span<const double> weights = weights_of(probe, (*probes_)[wanted.probe]);
    for (std::size_t k = 0; k < probe.nodes.size(); ++k)
      forces.segment<3>(3 * probe.nodes[k]) += force * weights[k] * probe.axes.col(wanted.index);
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
