#pragma once

#include <Eigen/Core>

#include "sim/surface/aabb_tree.hpp"
#include "sim/surface/touch_surface.hpp"

namespace palpate::sim {

/// Normal of a polygon, as long as twice its area.
Vec3 area_vector(const Triangle& corners, const Eigen::Matrix3Xd& positions);

/// Normals of the polygons around a node, each weighted with its angle there. Source: [Baerentzen2005].
Vec3 corner_normal(const TouchSurface& surface, const Eigen::Matrix3Xd& positions, int node);

/// Direction that tells inside from outside at a nearest point (the normal of face, edge or corner,
/// [Baerentzen2005]), of any length; zero where the patch ends, which decides nothing.
Vec3 outward_at(const TouchSurface& surface, const Eigen::Matrix3Xd& positions, const NearestPolygon& found);

/// How far bodies that touch at rest may seem apart by rounding [m]: what has touched or passed a surface must not
/// hang on the last bit of a distance. @param at_rest  tree of the surface
double rounding_of(const AabbTree& at_rest);

}  // namespace palpate::sim
