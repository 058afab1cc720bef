#pragma once

#include <limits>
#include <span>
#include <vector>

#include "sim/model/free_state.hpp"
#include "sim/model/model.hpp"

namespace palpate::sim {

/// How deep a place lies inside a surface [m]: its distance from the nearest polygon where it is behind that
/// (outward_at()), else 0. Polygons farther off than `within` plus what they have moved are not looked at.
/// @param moved  how far each polygon has moved [m]; empty: not at all
double depth_inside(const TouchSurface& surface, const AabbTree& tree, const Eigen::Matrix3Xd& positions,
                    const Vec3& place, double within = std::numeric_limits<double>::infinity(),
                    std::span<const double> moved = {});

/// Deepest overlap of each pair of bodies that may touch, beyond what they overlap at rest [m]; 0 where there is
/// none. Of a node only those polygons count that it can have come to by its motion and theirs. Outside the cycle.
std::vector<double> deepest_overlaps(const Model& model, const FreeMotion& motion);

}  // namespace palpate::sim
