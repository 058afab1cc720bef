#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "sim/contact/exact/system.hpp"
#include "sim/model/free_state.hpp"
#include "sim/model/model.hpp"
#include "sim/pairing/facing_pairs.hpp"

namespace palpate::sim {

/// What a region's motion does to the gaps.
struct RegionRows {
  int probe = 0;
  Eigen::MatrixXd gaps{};  // contacts x 12
};
std::vector<RegionRows> region_rows(const Model& model, std::span<const FacingPair> pairs);

/// gaps = rest gaps and what the regions have done to them.
void move_gaps(std::span<const RegionRows> regions, const ProbeRows& probes,
               std::span<const double> rest_gaps, std::span<double> gaps);

/// The rows of a probe that slides, at each of its knots.
struct SlidingRows {
  int probe = 0;
  std::vector<Eigen::MatrixXd>
      gaps{};  // of each knot, contacts x axes: what a newton along an axis does to them
};
std::vector<SlidingRows> sliding_rows(const Model& model, std::span<const FacingPair> pairs);

/// Brings the system's rows of the probes that slide to where they are.
void move_rows(const Model& model, std::span<const SlidingRows> sliding, const ProbeRows& probes,
               ContactSystem& system);

}  // namespace palpate::sim
