#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// Bounding boxes over the polygons of one body.
struct AabbTree {
  struct Node {
    Vec3 lower = Vec3::Zero(), upper = Vec3::Zero();  // [m]
    int left = -1, right = -1;                        // children, -1 in a leaf
    int first = 0, count = 0;                         // a leaf's polygons: order[first .. first + count)
  };
  std::vector<Node> nodes{};  // children stand behind their parent
  std::vector<int> order{};   // polygon numbers, grouped by leaf
};

AabbTree build_tree(std::span<const Triangle> triangles, const Eigen::Matrix3Xd& positions);

/// The point of a triangle nearest to a place, and whether it lies in its face, on an edge or at a corner.
struct NearestPoint {
  Vec3 point = Vec3::Zero();
  int edge = -1;    // k: on the edge from corner k to corner k+1
  int corner = -1;  // k: at corner k
};
NearestPoint nearest_on_triangle(const Vec3& place, const Vec3& a, const Vec3& b, const Vec3& c);

/// The polygon nearest to `place` of those that are no farther from it than `within` plus what they have moved
/// themselves. Ties go to the lower polygon number. polygon = -1 where there is none. What the tree looks like does
/// not change the answer.
/// @param moved  how far each polygon has moved [m]; empty: not at all
struct NearestPolygon {
  int polygon = -1;
  double squared_distance = 0.0;  // [m^2]
  NearestPoint nearest{};
};
NearestPolygon find_nearest(const AabbTree& tree, std::span<const Triangle> triangles,
                            const Eigen::Matrix3Xd& positions, const Vec3& place, double within,
                            std::span<const double> moved = {});

}  // namespace palpate::sim
