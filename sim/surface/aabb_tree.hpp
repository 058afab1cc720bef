#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// Bounding boxes over the polygons of one body, and how far the nodes inside each box have moved at most.
/// The shape is built once on the rest positions; refit() follows the body without allocating.
struct AabbTree {
  struct Node {
    Vec3 lower = Vec3::Zero(), upper = Vec3::Zero();  // [m]
    double reach = 0.0;                               // largest displacement of a node inside [m]
    int left = -1, right = -1;                        // children, -1 in a leaf
    int first = 0, count = 0;                         // a leaf's polygons: order[first .. first + count)
  };
  std::vector<Node> nodes{};  // children stand behind their parent
  std::vector<int> order{};   // polygon numbers, grouped by leaf
};

AabbTree build_tree(std::span<const Triangle> triangles, const Eigen::Matrix3Xd& positions);

/// @param positions, displacements  of the touchable nodes, 3 x t [m]
void refit(AabbTree& tree, std::span<const Triangle> triangles, const Eigen::Matrix3Xd& positions,
           Eigen::Ref<const Eigen::Matrix3Xd> displacements);

/// The point of a triangle nearest to a place, and whether it lies in its face, on an edge or at a corner.
struct NearestPoint {
  Vec3 point = Vec3::Zero();
  int edge = -1;    // k: on the edge from corner k to corner k+1
  int corner = -1;  // k: at corner k
};
NearestPoint nearest_on_triangle(const Vec3& place, const Vec3& a, const Vec3& b, const Vec3& c);

/// Where a place, and the polygons that it may have passed, were at rest.
struct CameFrom {
  const Vec3& place;
  const Eigen::Matrix3Xd& positions;
};

/// The polygon nearest to `place` among those that it can have reached: nearer than `moved` plus what the
/// polygon itself moved. With `from`, only those that it has come towards: nothing enters a body through a
/// surface that goes before it, however near its other side has come. Ties go to the lower polygon number.
/// polygon = -1 where there is none.
struct NearestPolygon {
  int polygon = -1;
  double squared_distance = 0.0;  // [m^2]
  NearestPoint nearest{};
};
NearestPolygon find_nearest(const AabbTree& tree, std::span<const Triangle> triangles,
                            const Eigen::Matrix3Xd& positions, const Vec3& place, double moved,
                            const CameFrom* from = nullptr);

}  // namespace palpate::sim
