#include "sim/contact/exact/complementarity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::sim {
namespace {

constexpr int kPatience = 3;  // block exchanges that may pass without fewer wrong signs [JudicePires1994]
constexpr int kMostRefinements = 3;  // of a solve with an updated factor
constexpr double kMargin = 1.001;  // of the forces that can close a contact: refinement changes them by less
constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();

}  // namespace

ComplementaritySolve::ComplementaritySolve(const ContactSystem& system)
    : system_(&system), factor_(system.compliance, kDelta), bound_(system) {
  const auto rows = static_cast<std::size_t>(system.compliance.rows());
  is_active_.resize(rows);
  wrong_.reserve(rows);
  kept_.reserve(rows);
  correction_.reserve(rows);
  forces_.setZero(system.compliance.rows());
  slack_.setZero(system.compliance.rows());
}

void ComplementaritySolve::reset() {
  factor_.clear();
  std::ranges::fill(is_active_, 0);
}

/// Puts the rows that hold before the contacts of the last solve.
void ComplementaritySolve::hold(std::span<const char> holds) {
  if (!changed_ && std::ranges::equal(holds, std::span(is_active_).first(holds.size())) &&
      !factor_.rows().empty())
    return;
  changed_ = false;
  kept_.clear();
  for (const int row : factor_.rows())
    if (row >= system_->bilateral) kept_.push_back(row);
  factor_.clear();
  holding_ = 0;
  for (std::size_t row = 0; row < holds.size(); ++row) {
    is_active_[row] = holds[row];
    if (!holds[row]) continue;
    factor_.append(static_cast<int>(row));
    ++holding_;
  }
  for (const int row : kept_) factor_.append(row);
}

/// What the rows would be without any force.
void ComplementaritySolve::begin_slack(std::span<const double> values, std::span<const double> gaps) {
  for (std::size_t i = 0; i < values.size(); ++i) slack_[static_cast<Eigen::Index>(i)] = -values[i];
  for (std::size_t i = 0; i < gaps.size(); ++i)
    slack_[system_->bilateral + static_cast<Eigen::Index>(i)] = gaps[i];
}

/// Leaves out the last contacts that x cannot have closed; an active one never, for it may be so by mistake.
void ComplementaritySolve::look_at_what_can_close(std::span<const double> gaps) {
  looked_at_ = slack_.size();
  if (system_->reach.empty()) return;
  const double pushed = kMargin * forces_.lpNorm<1>();
  std::size_t last = gaps.size();
  while (last > 0) {
    const double closed = system_->reach[last - 1] * pushed;
    const Eigen::Index row = system_->bilateral + static_cast<Eigen::Index>(last) - 1;
    if (gaps[last - 1] <= closed || is_active_[static_cast<std::size_t>(row)] != 0) break;
    slack_[row] = gaps[last - 1] - closed;
    looked_at_ = row;
    --last;
  }
}

void ComplementaritySolve::add_column(int row, double force) {
  if (system_->single.size() == 0)
    slack_.head(looked_at_).noalias() += force * system_->compliance.col(row).head(looked_at_);
  else
    slack_.head(looked_at_).noalias() += force * system_->single.col(row).head(looked_at_).cast<double>();
}

/// x and w with the active contacts closed and the others open. The factor's rounding is taken out by refinement
/// with K itself.
void ComplementaritySolve::solve_active(std::span<const double> values, std::span<const double> gaps) {
  const std::span<const int> rows = factor_.rows();
  forces_.setZero();
  begin_slack(values, gaps);
  double last = std::numeric_limits<double>::infinity();
  for (int refinement = 0; refinement <= kMostRefinements; ++refinement) {
    correction_.clear();
    double left = 0.0;
    for (const int row : rows) {
      const double rest = slack_[row] + kDelta * system_->compliance(row, row) * forces_[row];
      correction_.push_back(-rest);
      left = std::max(left, std::abs(rest) / system_->compliance(row, row));
    }
    if (left <= kRounding * forces_.lpNorm<Eigen::Infinity>() || left >= 0.5 * last) return;
    last = left;
    factor_.solve(correction_);
    for (std::size_t i = 0; i < rows.size(); ++i) forces_[rows[i]] += correction_[i];
    if (refinement == 0) look_at_what_can_close(gaps);
    for (std::size_t i = 0; i < rows.size(); ++i) add_column(rows[i], correction_[i]);
  }
}

/// Contacts that would pull, and open ones that overlap, by more than rounding explains.
std::size_t ComplementaritySolve::count_wrong() {
  wrong_.clear();
  const double least = kRounding * forces_.lpNorm<Eigen::Infinity>();
  for (auto row = static_cast<int>(system_->bilateral); row < forces_.size(); ++row) {
    const bool active = is_active_[static_cast<std::size_t>(row)] != 0;
    const double force = active ? forces_[row] : slack_[row] / system_->compliance(row, row);
    if (force < -least) wrong_.push_back(row);
  }
  return wrong_.size();
}

void ComplementaritySolve::exchange(bool all) {
  const std::span<const int> rows = all ? std::span<const int>(wrong_) : std::span<const int>(wrong_).last(1);
  for (const int row : rows) {
    char& active = is_active_[static_cast<std::size_t>(row)];
    if (active) {
      const std::span<const int> now = factor_.rows();
      factor_.remove(static_cast<std::size_t>(std::ranges::find(now, row) - now.begin()));
    } else {
      factor_.append(row);
    }
    active = active == 0 ? 1 : 0;
  }
}

double ComplementaritySolve::natural_residual() const {
  double error = 0.0, largest = 0.0;
  for (Eigen::Index row = system_->bilateral; row < forces_.size(); ++row) {
    const double slack = slack_[row] / system_->compliance(row, row);
    error = std::max(error, std::abs(forces_[row] - std::max(0.0, forces_[row] - slack)));
    largest = std::max(largest, forces_[row]);
  }
  return largest > 0.0 ? error / largest : 0.0;
}

/// Takes away forces that would pull, lets the probes bring their values again, and sees what gaps that leaves.
void ComplementaritySolve::settle(std::span<const double> values, std::span<const double> gaps) {
  const std::span<const int> rows = factor_.rows();
  for (Eigen::Index row = system_->bilateral; row < forces_.size(); ++row)
    forces_[row] = std::max(0.0, forces_[row]);
  begin_slack(values, gaps);
  correction_.clear();
  for (const int row : rows.first(holding_)) {
    double left = slack_[row];
    for (const int contact : rows.subspan(holding_))
      left += system_->compliance(row, contact) * forces_[contact];
    correction_.push_back(-left);
  }
  factor_.solve_leading(correction_, holding_);
  for (std::size_t i = 0; i < holding_; ++i) forces_[rows[i]] = correction_[i];
  look_at_what_can_close(gaps);
  for (const int row : rows) add_column(row, forces_[row]);
}

ComplementarityReport ComplementaritySolve::solve(std::span<const char> holds, std::span<const double> values,
                                                  std::span<const double> gaps, double tolerance) {
  using End = ComplementarityReport::End;
  hold(holds);
  ComplementarityReport report;
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  int patience = kPatience;
  while (report.iterations < kMostIterations) {
    ++report.iterations;
    solve_active(values, gaps);
    const std::size_t wrong = count_wrong();
    if (wrong == 0) {
      report.end = End::Converged;
      break;
    }
    if (tolerance > 0.0) {
      settle(values, gaps);
      if (bound_.find(factor_, holding_, forces_, slack_).within(tolerance, forces_)) {
        report.end = End::WithinTolerance;
        break;
      }
    }
    if (wrong < fewest) {
      fewest = wrong;
      patience = kPatience;
    } else {
      --patience;
    }
    exchange(patience >= 0);
  }
  settle(values, gaps);
  report.residual = natural_residual();
  report.force_error_bound = bound_.find(factor_, holding_, forces_, slack_).largest();
  return report;
}

}  // namespace palpate::sim
