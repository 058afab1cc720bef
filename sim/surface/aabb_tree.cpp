#include "sim/surface/aabb_tree.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace palpate::sim {
namespace {

constexpr int kLeafPolygons = 4;
constexpr std::size_t kDeepest = 64;  // of a tree split at the median: 2^64 polygons

Vec3 centre(const Triangle& triangle, const Eigen::Matrix3Xd& positions) {
  return (positions.col(triangle[0]) + positions.col(triangle[1]) + positions.col(triangle[2])) / 3.0;
}

/// Splits order[first, first + count) at the median of the longest extent of its centres.
int split(AabbTree& tree, int first, int count, std::span<const Triangle> triangles,
          const Eigen::Matrix3Xd& positions) {
  const int self = static_cast<int>(tree.nodes.size());
  tree.nodes.push_back({.first = first, .count = count});
  if (count <= kLeafPolygons) return self;
  Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity()), upper = -lower;
  const auto begin = tree.order.begin() + first;
  for (auto it = begin; it != begin + count; ++it) {
    const Vec3 place = centre(triangles[*it], positions);
    lower = lower.cwiseMin(place);
    upper = upper.cwiseMax(place);
  }
  int axis = 0;
  (upper - lower).maxCoeff(&axis);
  std::nth_element(begin, begin + count / 2, begin + count, [&](int a, int b) {
    const double at_a = centre(triangles[a], positions)[axis];
    const double at_b = centre(triangles[b], positions)[axis];
    return at_a != at_b ? at_a < at_b : a < b;
  });
  const int left = split(tree, first, count / 2, triangles, positions);
  const int right = split(tree, first + count / 2, count - count / 2, triangles, positions);
  AabbTree::Node& node = tree.nodes[self];
  node.left = left;
  node.right = right;
  return self;
}

/// Sets the boxes, children before their parents.
void fit(AabbTree& tree, std::span<const Triangle> triangles, const Eigen::Matrix3Xd& positions) {
  for (auto node = tree.nodes.rbegin(); node != tree.nodes.rend(); ++node) {
    if (node->left >= 0) {
      const AabbTree::Node& left = tree.nodes[node->left];
      const AabbTree::Node& right = tree.nodes[node->right];
      node->lower = left.lower.cwiseMin(right.lower);
      node->upper = left.upper.cwiseMax(right.upper);
      continue;
    }
    Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity()), upper = -lower;
    for (int i = node->first; i < node->first + node->count; ++i) {
      for (const int corner : triangles[tree.order[i]]) {
        lower = lower.cwiseMin(positions.col(corner));
        upper = upper.cwiseMax(positions.col(corner));
      }
    }
    node->lower = lower;
    node->upper = upper;
  }
}

double squared_distance_to_box(const Vec3& place, const AabbTree::Node& box) {
  return ((box.lower - place).cwiseMax(place - box.upper)).cwiseMax(0.0).squaredNorm();
}

}  // namespace

AabbTree build_tree(std::span<const Triangle> triangles, const Eigen::Matrix3Xd& positions) {
  AabbTree tree;
  if (triangles.empty()) return tree;
  for (int i = 0; i < static_cast<int>(triangles.size()); ++i) tree.order.push_back(i);
  split(tree, 0, static_cast<int>(triangles.size()), triangles, positions);
  fit(tree, triangles, positions);
  return tree;
}

// The regions of the plane are told apart by barycentric signs. Source: [Ericson2005] section 5.1.5.
NearestPoint nearest_on_triangle(const Vec3& place, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = place - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {.point = a, .corner = 0};
  const Vec3 bp = place - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return {.point = b, .corner = 1};
  const Vec3 cp = place - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return {.point = c, .corner = 2};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {.point = a + d1 / (d1 - d3) * ab, .edge = 0};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
    return {.point = b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), .edge = 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {.point = a + d2 / (d2 - d6) * ac, .edge = 2};
  const double scale = 1.0 / (va + vb + vc);
  return {.point = a + ab * (vb * scale) + ac * (vc * scale)};
}

NearestPolygon find_nearest(const AabbTree& tree, std::span<const Triangle> triangles,
                            const Eigen::Matrix3Xd& positions, const Vec3& place, double within,
                            std::span<const double> moved) {
  NearestPolygon best{.squared_distance = std::numeric_limits<double>::infinity()};
  if (tree.nodes.empty()) return best;
  // where polygons have moved by different amounts, nothing but the nearest one so far bounds the search
  const double farthest = moved.empty() ? within * within : std::numeric_limits<double>::infinity();
  std::array<int, kDeepest> stack{};
  std::size_t height = 0;
  stack[height++] = 0;
  while (height > 0) {
    const AabbTree::Node& node = tree.nodes[stack[--height]];
    if (squared_distance_to_box(place, node) > std::min(best.squared_distance, farthest)) continue;
    if (node.left >= 0) {
      assert(height + 2 <= kDeepest);
      const bool left_first = squared_distance_to_box(place, tree.nodes[node.left]) <=
                              squared_distance_to_box(place, tree.nodes[node.right]);
      stack[height++] = left_first ? node.right : node.left;
      stack[height++] = left_first ? node.left : node.right;
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const int polygon = tree.order[i];
      const Triangle& corners = triangles[polygon];
      const NearestPoint nearest = nearest_on_triangle(place, positions.col(corners[0]),
                                                       positions.col(corners[1]), positions.col(corners[2]));
      const double squared = (nearest.point - place).squaredNorm();
      const bool nearer =
          squared < best.squared_distance || (squared == best.squared_distance && polygon < best.polygon);
      const double reach = moved.empty() ? within : within + moved[polygon];
      if (nearer && squared <= reach * reach) best = {polygon, squared, nearest};
    }
  }
  return best;
}

}  // namespace palpate::sim
