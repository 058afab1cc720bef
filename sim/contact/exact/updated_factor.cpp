#include "sim/contact/exact/updated_factor.hpp"

#include <algorithm>
#include <cmath>

namespace palpate::sim {
namespace {

using RowMap = Eigen::Map<const Eigen::VectorXd>;

}  // namespace

UpdatedFactor::UpdatedFactor(const Eigen::MatrixXd& matrix, double delta)
    : matrix_(&matrix),
      delta_(delta),
      stride_(static_cast<std::size_t>(matrix.rows())),
      factor_(stride_ * stride_) {
  rows_.reserve(stride_);
  rotations_.reserve(stride_);
}

void UpdatedFactor::append(int added) {
  const auto n = static_cast<Eigen::Index>(rows_.size());
  double* const last = row(rows_.size());
  for (Eigen::Index i = 0; i < n; ++i) {
    const double* const above = row(static_cast<std::size_t>(i));
    last[i] =
        ((*matrix_)(rows_[static_cast<std::size_t>(i)], added) - RowMap(above, i).dot(RowMap(last, i))) /
        above[i];
  }
  const double diagonal = (*matrix_)(added, added);
  // A row that others give already leaves nothing but delta; rounding must not make that less.
  const double rest =
      std::max((1.0 + delta_) * diagonal - RowMap(last, n).squaredNorm(), 0.5 * delta_ * diagonal);
  last[n] = std::sqrt(rest);
  rows_.push_back(added);
}

void UpdatedFactor::remove(std::size_t at) {
  // The rows below move up by one, each with an entry beyond its diagonal that plane rotations of neighbouring
  // columns take away. A row goes through the rotations of the rows above it, kept in the row that is no more.
  const std::size_t n = rows_.size();
  rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(at));
  rotations_.clear();
  for (std::size_t i = at + 1; i < n; ++i) {
    double* const from = row(i);
    double* const to = row(i - 1);
    std::copy(from, from + at, to);
    double carried = from[at];
    for (std::size_t j = at; j + 1 < i; ++j) {
      const auto [c, s] = rotations_[j - at];
      to[j] = c * carried + s * from[j + 1];
      carried = c * from[j + 1] - s * carried;
    }
    const double length = std::hypot(carried, from[i]);
    rotations_.push_back({carried / length, from[i] / length});
    to[i - 1] = length;
  }
}

void UpdatedFactor::forward(std::span<double> x) const {
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto size = static_cast<Eigen::Index>(i);
    x[i] = (x[i] - RowMap(row(i), size).dot(RowMap(x.data(), size))) / row(i)[i];
  }
}

void UpdatedFactor::backward(std::span<double> x) const {
  for (std::size_t i = x.size(); i-- > 0;) {
    const auto size = static_cast<Eigen::Index>(i);
    x[i] /= row(i)[i];
    Eigen::Map<Eigen::VectorXd>(x.data(), size) -= x[i] * RowMap(row(i), size);
  }
}

void UpdatedFactor::solve_leading(std::span<double> x, std::size_t count) const {
  forward(x.first(count));
  backward(x.first(count));
}

}  // namespace palpate::sim
