#include "sim/compile/overlap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "sim/pairing/overlaps.hpp"
#include "sim/scene/refuse_key.hpp"
#include "sim/surface/ray.hpp"

namespace palpate::sim {
namespace {

constexpr double kRounding = 1e-9;  // of a body's size
constexpr int kPlaces = 15;         // looked at between two crossings of the boundary

/// A body's whole boundary, at rest.
struct Boundary {
  Eigen::Matrix3Xd nodes{};
  TouchSurface surface{};
  AabbTree tree{};
};

Boundary boundary_of(const Body& body) {
  const std::size_t count = body.mesh->nodes.size();
  std::vector<int> every(count);
  std::iota(every.begin(), every.end(), 0);
  Boundary boundary{.nodes = Eigen::Matrix3Xd(3, static_cast<Eigen::Index>(count)),
                    .surface = make_touch_surface(body.surface->triangles, every, static_cast<int>(count))};
  for (std::size_t i = 0; i < count; ++i)
    boundary.nodes.col(static_cast<Eigen::Index>(i)) = body.mesh->nodes[i];
  boundary.tree = build_tree(boundary.surface.triangles, boundary.nodes);
  return boundary;
}

bool apart(const AabbTree::Node& box, const Vec3& lower, const Vec3& upper) {
  return (lower.array() > box.upper.array()).any() || (upper.array() < box.lower.array()).any();
}

double depth_of(const Vec3& place, const Boundary& in) {
  if (apart(in.tree.nodes.front(), place, place)) return 0.0;
  return depth_inside(in.surface, in.tree, in.nodes, place);
}

/// Where a segment crosses the boundary, as distances from its beginning, ascending.
std::vector<double> crossings(const Vec3& from, const Vec3& along, double length, const Boundary& boundary) {
  const Vec3 to = from + length * along;
  const Vec3 lower = from.cwiseMin(to), upper = from.cwiseMax(to);
  std::vector<double> found;
  std::vector<int> open{0};
  while (!open.empty()) {
    const AabbTree::Node& box = boundary.tree.nodes[open.back()];
    open.pop_back();
    if (apart(box, lower, upper)) continue;
    if (box.left >= 0) {
      open.insert(open.end(), {box.left, box.right});
      continue;
    }
    for (int i = box.first; i < box.first + box.count; ++i) {
      const auto [a, b, c] = boundary.surface.triangles[boundary.tree.order[i]];
      const double at = distance_to_triangle(from, along, boundary.nodes.col(a), boundary.nodes.col(b),
                                             boundary.nodes.col(c));
      if (at < length) found.push_back(at);
    }
  }
  std::ranges::sort(found);
  return found;
}

/// Deepest place of a segment inside the boundary, of those between two of its crossings. One that does not cross
/// it is inside or outside with its ends.
double deepest_on_segment(const Vec3& from, const Vec3& to, const Boundary& in) {
  const double length = (to - from).norm();
  const Vec3 along = (to - from) / length;
  std::vector<double> ends = crossings(from, along, length, in);
  if (ends.empty()) return 0.0;
  ends.insert(ends.begin(), 0.0);
  ends.push_back(length);
  double deepest = 0.0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    for (int k = 1; k <= kPlaces; ++k) {
      const double at = ends[i] + (ends[i + 1] - ends[i]) * k / (kPlaces + 1);
      deepest = std::max(deepest, depth_of(from + at * along, in));
    }
  return deepest;
}

std::set<std::pair<int, int>> edges_of(const Surface& surface) {
  std::set<std::pair<int, int>> edges;
  for (const auto& [a, b, c] : surface.triangles)
    for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}}) edges.insert(std::minmax(from, to));
  return edges;
}

double deepest_in(const Body& inner, const Boundary& outer) {
  const std::vector<Vec3>& nodes = inner.mesh->nodes;
  double deepest = 0.0;
  for (const Vec3& node : nodes) deepest = std::max(deepest, depth_of(node, outer));
  for (const auto& [a, b, c, d] : inner.mesh->tetrahedra)
    deepest = std::max(deepest, depth_of((nodes[a] + nodes[b] + nodes[c] + nodes[d]) / 4.0, outer));
  for (const auto& [from, to] : edges_of(*inner.surface))
    deepest = std::max(deepest, deepest_on_segment(nodes[from], nodes[to], outer));
  return deepest;
}

double size_of(const Body& body) {
  Vec3 lower = body.mesh->nodes.front(), upper = lower;
  for (const Vec3& node : body.mesh->nodes) {
    lower = lower.cwiseMin(node);
    upper = upper.cwiseMax(node);
  }
  return (upper - lower).norm();
}

}  // namespace

double overlap_at_rest(const Body& a, const Body& b) {
  return std::max(deepest_in(a, boundary_of(b)), deepest_in(b, boundary_of(a)));
}

void refuse_overlap(const Body& a, const Body& b, double declared) {
  const double overlap = overlap_at_rest(a, b);
  if (overlap <= declared + kRounding * size_of(a)) return;
  const std::string overlapping =
      fmt::format("{} and {} overlap at rest by {:.3g} mm", a.name, b.name, 1e3 * overlap);
  if (declared > 0.0)
    refuse_key("contact.overlap",
               fmt::format("found {:.6g} mm, and {}; accepted: at least that, or bodies that "
                           "are moved apart (see offset)",
                           1e3 * declared, overlapping));
  refuse_key("bodies",
             fmt::format("{}; accepted: bodies that are apart or touch (see offset), or contact.overlap "
                         "to declare it",
                         overlapping));
}

}  // namespace palpate::sim
