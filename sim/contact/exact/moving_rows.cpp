#include "sim/contact/exact/moving_rows.hpp"

#include <algorithm>

#include "sim/contact/exact/contact_system.hpp"

namespace palpate::sim {
namespace {

/// How motions of a body's touchable nodes (3t x columns) open the gaps of the pairs: contacts x columns.
Eigen::MatrixXd all_opened(std::span<const FacingPair> pairs, int body, const Eigen::MatrixXd& motion) {
  Eigen::MatrixXd gaps(std::ssize(pairs), motion.cols());
  for (Eigen::Index row = 0; row < gaps.rows(); ++row)
    for (Eigen::Index column = 0; column < motion.cols(); ++column)
      gaps(row, column) = opened_by(pairs[static_cast<std::size_t>(row)], body, motion.col(column));
  return gaps;
}

}  // namespace

std::vector<RegionRows> region_rows(const Model& model, std::span<const FacingPair> pairs) {
  std::vector<RegionRows> rows;
  for (int p = 0; p < std::ssize(model.probes); ++p)
    if (const auto& region = model.probes[p].region)
      rows.push_back({p, all_opened(pairs, model.probes[p].body, region->touch_motion)});
  return rows;
}

void move_gaps(std::span<const RegionRows> regions, const ProbeRows& probes,
               std::span<const double> rest_gaps, std::span<double> gaps) {
  std::ranges::copy(rest_gaps, gaps.begin());
  Eigen::Map<Eigen::VectorXd> moved(gaps.data(), std::ssize(gaps));
  for (const RegionRows& rows : regions) moved.noalias() += rows.gaps * probes[rows.probe].region;
}

std::vector<SlidingRows> sliding_rows(const Model& model, std::span<const FacingPair> pairs) {
  std::vector<SlidingRows> rows;
  for (int p = 0; p < std::ssize(model.probes); ++p) {
    const Probe& probe = model.probes[p];
    if (probe.slide.knots.empty()) continue;
    SlidingRows& sliding = rows.emplace_back(SlidingRows{.probe = p});
    for (const Knot& knot : probe.slide.knots)
      sliding.gaps.push_back(all_opened(pairs, probe.body, knot.compliance) /
                             model.bodies[probe.body].young_modulus);
  }
  return rows;
}

void move_rows(const Model& model, std::span<const SlidingRows> sliding, const ProbeRows& probes,
               ContactSystem& system) {
  for (const SlidingRows& rows : sliding) {
    const ProbeRow& row = probes[rows.probe];
    const Eigen::Index first = system.first_of_probe[rows.probe], axes = model.probes[rows.probe].axes.cols();
    const Eigen::Index contacts = rows.gaps.front().rows();
    auto columns = system.compliance.block(system.bilateral, first, contacts, axes);
    columns.setZero();
    for (std::size_t k = 0; k < row.knots.size(); ++k)
      columns += row.shares[static_cast<Eigen::Index>(k)] * rows.gaps[row.knots[k]];
    system.compliance.block(first, system.bilateral, axes, contacts) = columns.transpose();
  }
  fill_probes(model, probes, system);
}

}  // namespace palpate::sim
