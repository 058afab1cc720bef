#include "sim/contact/frictional/coulomb.hpp"

#include <algorithm>
#include <cmath>

#include "sim/contact/exact/system.hpp"
#include "sim/contact/frictional/dense_solve.hpp"

namespace palpate::sim {
namespace {

constexpr double kEnough = 1e-11;  // of the residual: delta leaves 1e-12
constexpr int kNewtonSteps = 25;   // before sweeps help
constexpr int kSweeps = 15;

}  // namespace

CoulombSolve::CoulombSolve(const FrictionSystem& system) : system_(&system) {
  const Eigen::Index size = system.compliance.rows();
  const std::size_t contacts = system.frames.size();
  forces_.setZero(size);
  slack_.setZero(size);
  touch_.resize(contacts, Touch::Open);
  slips_.resize(contacts, Eigen::Vector2d::Zero());
  shrink_.resize(contacts);
  unknowns_.reserve(static_cast<std::size_t>(size));
  matrix_.reserve(static_cast<std::size_t>(size * size));
  right_.reserve(static_cast<std::size_t>(size));
}

void CoulombSolve::find_slack(std::span<const Vec3> gaps, std::span<const int> near) {
  for (const int contact : near) slack_.segment<3>(row_of(contact)) = gaps[contact];
  const auto add = [&](Eigen::Index column) {
    if (forces_[column] == 0.0) return;
    for (const int contact : near)
      slack_.segment<3>(row_of(contact)) +=
          forces_[column] * system_->compliance.block<3, 1>(row_of(contact), column);
  };
  for (Eigen::Index i = 0; i < system_->bilateral; ++i) add(i);
  for (const int contact : near)
    for (Eigen::Index k = 0; k < 3; ++k) add(row_of(contact) + k);
}

/// x - w / D of a contact, its tangential part scaled alike in both directions.
namespace {
Vec3 stepped(const FrictionSystem& system, const Eigen::VectorXd& x, const Eigen::VectorXd& w,
             Eigen::Index row) {
  const auto& K = system.compliance;
  const double tangential = 0.5 * (K(row + 1, row + 1) + K(row + 2, row + 2));
  return {x[row] - w[row] / K(row, row), x[row + 1] - w[row + 1] / tangential,
          x[row + 2] - w[row + 2] / tangential};
}
}  // namespace

Vec3 CoulombSolve::projected(double friction, int contact) const {
  Vec3 z = stepped(*system_, forces_, slack_, row_of(contact));
  z[0] = std::max(0.0, z[0]);
  const double most = friction * z[0], length = z.tail<2>().norm();
  if (length > most) z.tail<2>() *= most / length;
  return z;
}

double CoulombSolve::residual(double friction, std::span<const int> near) const {
  double error = 0.0, largest = 0.0;
  for (const int contact : near) {
    const Vec3 x = forces_.segment<3>(row_of(contact));
    error = std::max(error, (x - projected(friction, contact)).lpNorm<Eigen::Infinity>());
    largest = std::max(largest, x.lpNorm<Eigen::Infinity>());
  }
  return largest > 0.0 ? error / largest : error;
}

void CoulombSolve::classify(double friction, std::span<const int> near) {
  for (const int contact : near) {
    const Vec3 z = stepped(*system_, forces_, slack_, row_of(contact));
    const double most = friction * z[0], length = z.tail<2>().norm();
    Touch& touch = touch_[static_cast<std::size_t>(contact)];
    touch = z[0] <= 0.0 ? Touch::Open : length <= most ? Touch::Sticks : Touch::Slips;
    if (touch != Touch::Slips) continue;
    slips_[static_cast<std::size_t>(contact)] = z.tail<2>() / length;
    shrink_[static_cast<std::size_t>(contact)] = most / length;
  }
}

/// The three equations of a closed contact.
void CoulombSolve::write_contact(double friction, int contact, std::span<const Vec3> gaps,
                                 Eigen::Index& equation) {
  const auto& K = system_->compliance;
  const Eigen::Index row = row_of(contact), size = std::ssize(unknowns_);
  const auto line = [&](Eigen::Index k) { return matrix_.data() + (equation + k) * size; };
  const auto gap_row = [&](Eigen::Index k) {
    for (Eigen::Index j = 0; j < size; ++j) {
      line(k)[j] = K(row + k, unknowns_[static_cast<std::size_t>(j)]);
      if (unknowns_[static_cast<std::size_t>(j)] == row + k) line(k)[j] *= 1.0 + kDelta;
    }
    right_[static_cast<std::size_t>(equation + k)] = -gaps[contact][k];
  };
  gap_row(0);
  if (touch_[static_cast<std::size_t>(contact)] == Touch::Sticks) {
    gap_row(1);
    gap_row(2);
  } else {
    // x_t = mu x_n d + beta (I - d d^T) (x_t - w_t / D), d and beta of the last step
    const Eigen::Vector2d& d = slips_[static_cast<std::size_t>(contact)];
    const double beta = shrink_[static_cast<std::size_t>(contact)];
    const double scale = 0.5 * (K(row + 1, row + 1) + K(row + 2, row + 2));
    const Eigen::Matrix2d across = beta * (Eigen::Matrix2d::Identity() - d * d.transpose());
    const Eigen::Vector2d given = -across * gaps[contact].tail<2>();
    for (Eigen::Index k = 0; k < 2; ++k) {
      for (Eigen::Index j = 0; j < size; ++j) {
        const Eigen::Index unknown = unknowns_[static_cast<std::size_t>(j)];
        double entry = across(k, 0) * K(row + 1, unknown) + across(k, 1) * K(row + 2, unknown);
        if (unknown == row) entry -= scale * friction * d[k];
        if (unknown > row && unknown <= row + 2)
          entry += scale * ((unknown == row + 1 + k ? 1.0 : 0.0) - across(k, unknown - row - 1));
        line(k + 1)[j] = entry;
      }
      right_[static_cast<std::size_t>(equation + k + 1)] = given[k];
    }
  }
  equation += 3;
}

bool CoulombSolve::newton_step(double friction, std::span<const char> holds, std::span<const double> values,
                               std::span<const Vec3> gaps, std::span<const int> near) {
  unknowns_.clear();
  for (std::size_t i = 0; i < holds.size(); ++i)
    if (holds[i]) unknowns_.push_back(static_cast<Eigen::Index>(i));
  const auto held = std::ssize(unknowns_);
  for (const int contact : near)
    if (touch_[static_cast<std::size_t>(contact)] != Touch::Open)
      for (Eigen::Index k = 0; k < 3; ++k) unknowns_.push_back(row_of(contact) + k);
  const auto size = std::ssize(unknowns_);
  matrix_.resize(static_cast<std::size_t>(size * size));
  right_.resize(static_cast<std::size_t>(size));
  for (Eigen::Index i = 0; i < held; ++i) {
    for (Eigen::Index j = 0; j < size; ++j)
      matrix_[static_cast<std::size_t>(i * size + j)] =
          system_->compliance(unknowns_[static_cast<std::size_t>(i)], unknowns_[static_cast<std::size_t>(j)]);
    right_[static_cast<std::size_t>(i)] =
        values[static_cast<std::size_t>(unknowns_[static_cast<std::size_t>(i)])];
  }
  Eigen::Index equation = held;
  for (const int contact : near)
    if (touch_[static_cast<std::size_t>(contact)] != Touch::Open)
      write_contact(friction, contact, gaps, equation);
  if (!solve_dense(matrix_, right_)) return false;
  forces_.setZero();
  for (std::size_t i = 0; i < unknowns_.size(); ++i) forces_[unknowns_[i]] = right_[i];
  return forces_.allFinite();
}

/// One pass of projected Gauss-Seidel over the contacts, then the probes bring their values again.
void CoulombSolve::sweep(double friction, std::span<const char> holds, std::span<const double> values,
                         std::span<const Vec3> gaps, std::span<const int> near) {
  for (const int contact : near) {
    const Eigen::Index row = row_of(contact);
    const Vec3 change = projected(friction, contact) - forces_.segment<3>(row);
    if (change.isZero(0.0)) continue;
    forces_.segment<3>(row) += change;
    for (const int other : near)
      slack_.segment<3>(row_of(other)) += system_->compliance.block<3, 3>(row_of(other), row) * change;
  }
  right_.assign(holds.size(), 0.0);
  for (std::size_t i = 0; i < holds.size(); ++i) {
    right_[i] = values[i];
    for (const int contact : near)
      right_[i] -= system_->compliance.block<1, 3>(static_cast<Eigen::Index>(i), row_of(contact))
                       .dot(forces_.segment<3>(row_of(contact)));
  }
  solve_bilateral(holds, right_);
  for (std::size_t i = 0; i < holds.size(); ++i) forces_[static_cast<Eigen::Index>(i)] = right_[i];
  find_slack(gaps, near);
}

void CoulombSolve::solve_bilateral(std::span<const char> holds, std::span<double> values) {
  unknowns_.clear();
  for (std::size_t i = 0; i < holds.size(); ++i)
    if (holds[i]) unknowns_.push_back(static_cast<Eigen::Index>(i));
  const std::size_t size = unknowns_.size();
  matrix_.resize(size * size);
  for (std::size_t i = 0; i < size; ++i) {
    values[i] = values[static_cast<std::size_t>(unknowns_[i])];
    for (std::size_t j = 0; j < size; ++j)
      matrix_[i * size + j] = system_->compliance(unknowns_[i], unknowns_[j]);
  }
  solve_dense(matrix_, values.first(size));
  for (std::size_t i = size, row = holds.size(); row-- > 0;) values[row] = holds[row] ? values[--i] : 0.0;
}

CoulombReport CoulombSolve::solve(double friction, std::span<const char> holds,
                                  std::span<const double> values, std::span<const Vec3> gaps,
                                  std::span<const int> near) {
  CoulombReport report;
  find_slack(gaps, near);
  int since_sweeps = 0;
  while (report.iterations < kMostIterations) {
    ++report.iterations;
    classify(friction, near);
    const bool stepped = newton_step(friction, holds, values, gaps, near);
    if (!stepped) forces_.setZero();
    find_slack(gaps, near);
    report.residual = residual(friction, near);
    if (report.residual <= kEnough) break;
    if (++since_sweeps < kNewtonSteps && stepped) continue;
    for (int i = 0; i < kSweeps; ++i, ++report.iterations) sweep(friction, holds, values, gaps, near);
    since_sweeps = 0;
  }
  report.converged = report.residual <= kEnough;
  classify(friction, near);
  std::ranges::fill(right_, 0.0);
  for (std::size_t contact = 0; contact < touch_.size(); ++contact) {
    auto x = forces_.segment<3>(row_of(static_cast<int>(contact)));
    x[0] = std::max(0.0, x[0]);
    const double most = friction * x[0], length = x.tail<2>().norm();
    if (length > most) x.tail<2>() *= most / length;
  }
  return report;
}

}  // namespace palpate::sim
