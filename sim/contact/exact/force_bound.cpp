#include "sim/contact/exact/force_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {
namespace {

using Map = Eigen::Map<const Eigen::VectorXd>;

Map contacts(const std::vector<double>& rows, std::size_t holding) {
  return {rows.data() + holding, static_cast<Eigen::Index>(rows.size() - holding)};
}

}  // namespace

ForceBound::ForceBound(const ContactSystem& system) : system_(&system) {
  const auto rows = static_cast<std::size_t>(system.compliance.rows());
  taken_.resize(rows);
  change_.reserve(rows);
  axis_.reserve(rows);
  bounds_.resize(system.first_of_probe.size() - 1);
}

/// To first order, what delta on the active rows and rounding of the gaps do to the force along an axis, with
/// z = W^-1 c: sum of |z_i| (delta D_i lambda_i + rounding_i). A gap is a sum over the active rows of at most
/// sqrt(K_ii K_jj) |x_j|, each rounded; with K in single precision, each by half of that precision's last bit as well.
double ForceBound::first_order(const UpdatedFactor& factor, std::size_t holding,
                               const Eigen::VectorXd& forces) {
  const std::span<const int> rows = factor.rows();
  double sum = 0.0;
  for (const int row : rows) sum += std::sqrt(system_->compliance(row, row)) * std::abs(forces[row]);
  double rounding = std::numeric_limits<double>::epsilon() * static_cast<double>(rows.size()) * sum;
  if (system_->single.size() > 0) rounding += 0.5 * double{std::numeric_limits<float>::epsilon()} * sum;
  std::ranges::fill(std::span(axis_).first(holding), 0.0);
  factor.backward(axis_);
  double effect = 0.0;
  for (std::size_t i = holding; i < rows.size(); ++i) {
    const double diagonal = system_->compliance(rows[i], rows[i]);
    effect += std::abs(axis_[i]) * (kDelta * diagonal * forces[rows[i]] + std::sqrt(diagonal) * rounding);
  }
  return effect;
}

/// Appends the contacts that may be closed on the way to the exact solution, and finds L^-1 r and rho over them.
void ForceBound::grow(UpdatedFactor& factor, std::size_t holding, const Eigen::VectorXd& forces,
                      const Eigen::VectorXd& slack) {
  std::ranges::fill(taken_, 0);
  for (const int row : factor.rows()) taken_[static_cast<std::size_t>(row)] = 1;
  rho_ = 0.0;
  std::size_t before = 0;
  do {
    before = factor.rows().size();
    for (Eigen::Index row = system_->bilateral; row < forces.size(); ++row) {
      if (taken_[static_cast<std::size_t>(row)] ||
          slack[row] > std::sqrt(system_->compliance(row, row)) * rho_)
        continue;
      taken_[static_cast<std::size_t>(row)] = 1;
      factor.append(static_cast<int>(row));
    }
    const std::span<const int> rows = factor.rows();
    change_.assign(rows.size(), 0.0);
    for (std::size_t i = holding; i < rows.size(); ++i) {
      const double force = forces[rows[i]];
      const double shared = kDelta * system_->compliance(rows[i], rows[i]) * force;
      change_[i] = force > 0.0 ? -slack[rows[i]] - shared : std::max(0.0, -slack[rows[i]]);
    }
    factor.forward(change_);
    rho_ = contacts(change_, holding).norm();
  } while (before != factor.rows().size());
}

/// One component of a probe's force, which axis_ holds as what each row does to it.
void ForceBound::add(int probe, UpdatedFactor& factor, std::size_t holding, const Eigen::VectorXd& forces) {
  factor.forward(axis_);
  const Map coupling = contacts(axis_, holding);
  const double ball = 0.5 * (std::abs(coupling.dot(contacts(change_, holding))) + coupling.norm() * rho_);
  double& bound = bounds_[static_cast<std::size_t>(probe)];
  bound = std::hypot(bound, ball + 2.0 * first_order(factor, holding, forces));
}

const ForceBound& ForceBound::find(UpdatedFactor& factor, std::size_t holding, const Eigen::VectorXd& forces,
                                   const Eigen::VectorXd& slack) {
  std::ranges::fill(bounds_, 0.0);
  const std::size_t active = factor.rows().size();
  if (holding == 0 && system_->regions.empty()) return *this;  // a probe that does not press feels nothing
  grow(factor, holding, forces, slack);
  const std::span<const int> rows = factor.rows();
  for (std::size_t i = 0; i < holding; ++i) {
    axis_.assign(rows.size(), 0.0);
    axis_[i] = 1.0;
    const auto probe =
        std::ranges::upper_bound(system_->first_of_probe, rows[i]) - system_->first_of_probe.begin();
    add(static_cast<int>(probe) - 1, factor, holding, forces);
  }
  for (const RegionPull& region : system_->regions)
    for (Eigen::Index component = 0; component < 3; ++component) {
      axis_.clear();
      for (const int row : rows) axis_.push_back(region.rows(row, component));
      add(region.probe, factor, holding, forces);
    }
  factor.truncate(active);
  return *this;
}

double ForceBound::largest() const {
  return bounds_.empty() ? 0.0 : std::ranges::max(bounds_);
}

bool ForceBound::within(double part, const Eigen::VectorXd& forces) const {
  for (std::size_t probe = 0; probe < bounds_.size(); ++probe) {
    const Eigen::Index first = system_->first_of_probe[probe];
    const Eigen::Index axes = system_->first_of_probe[probe + 1] - first;
    if (axes > 0 && bounds_[probe] > part * forces.segment(first, axes).norm()) return false;
  }
  for (const RegionPull& region : system_->regions) {
    const Vec3 pull = region.rows.transpose() * forces;
    if (bounds_[static_cast<std::size_t>(region.probe)] > part * pull.norm()) return false;
  }
  return true;
}

}  // namespace palpate::sim
