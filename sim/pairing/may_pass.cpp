#include "sim/pairing/may_pass.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "sim/pairing/outward.hpp"

namespace palpate::sim {
namespace {

constexpr double kSquare = 1e-9;  // cosine of two polygons at right angles, by rounding
constexpr double kNever = std::numeric_limits<double>::infinity();

std::vector<Vec3> normals_of(const Body& body) {
  std::vector<Vec3> normals;
  for (const Triangle& corners : body.polygons.triangles)
    normals.push_back(area_vector(corners, body.rest).normalized());
  return normals;
}

/// One body's nodes and the other's polygons, at rest.
struct AtRest {
  const Body &nodes, &polygons;
  std::vector<Vec3> normals_of_nodes, normals_of_polygons;  // of the polygons of each
  double overlap = 0.0;                                     // declared [m]
  double rounding = 0.0;                                    // [m]
};

/// Whether a polygon beside the node faces one with this normal, be it ever so little.
bool faces(const AtRest& rest, int node, const Vec3& normal) {
  const TouchSurface& own = rest.nodes.polygons;
  return std::any_of(own.incident.begin() + own.incident_begin[node],
                     own.incident.begin() + own.incident_begin[node + 1],
                     [&](int beside) { return rest.normals_of_nodes[beside].dot(normal) < -kSquare; });
}

/// Adds the polygons that a node may pass.
void list_polygons(const AtRest& rest, int node, std::vector<MayPass>& list) {
  const auto& triangles = rest.polygons.polygons.triangles;
  const Vec3 place = rest.nodes.rest.col(node);
  for (int polygon = 0; polygon < std::ssize(triangles); ++polygon) {
    const auto [a, b, c] = triangles[polygon];
    const Vec3 corner = rest.polygons.rest.col(a), normal = rest.normals_of_polygons[polygon];
    const double behind = (corner - place).dot(normal);
    if (behind > rest.overlap + rest.rounding || !faces(rest, node, normal)) continue;
    const Vec3 nearest =
        nearest_on_triangle(place, corner, rest.polygons.rest.col(b), rest.polygons.rest.col(c)).point;
    const double gap = (nearest - place).norm();
    const bool touching = behind >= -rest.rounding && gap <= rest.overlap + rest.rounding;
    if (touching || behind <= rest.rounding) list.push_back({touching ? 0.0 : gap, polygon, touching});
  }
}

MeetingSides sides_at_rest(const Model& model, int touch_pair, int node_body, int polygon_body) {
  const Body &nodes = model.bodies[node_body], &polygons = model.bodies[polygon_body];
  MeetingSides sides{.touch_pair = touch_pair,
                     .node_body = node_body,
                     .polygon_body = polygon_body,
                     .least_gap = kNever,
                     .begin = {0}};
  if (!polygons.tree.nodes.empty()) sides.rounding = rounding_of(polygons.tree);
  const AtRest rest{nodes, polygons, normals_of(nodes), normals_of(polygons), model.overlap, sides.rounding};
  for (const int node : nodes.colliding_nodes) {
    const int first = sides.begin.back();
    list_polygons(rest, node, sides.polygons);
    std::sort(sides.polygons.begin() + first, sides.polygons.end(), [](const MayPass& a, const MayPass& b) {
      return std::tie(a.gap, a.polygon) < std::tie(b.gap, b.polygon);
    });
    sides.begin.push_back(static_cast<int>(sides.polygons.size()));
    sides.gap.push_back(sides.begin.back() == first ? kNever : sides.polygons[first].gap);
    sides.least_gap = std::min(sides.least_gap, sides.gap.back());
  }
  return sides;
}

}  // namespace

std::vector<MeetingSides> meeting_sides(const Model& model) {
  std::vector<MeetingSides> all;
  for (int p = 0; p < std::ssize(model.pairs); ++p) {
    const auto [a, b] = model.pairs[p].bodies;
    all.push_back(sides_at_rest(model, p, a, b));
    all.push_back(sides_at_rest(model, p, b, a));
  }
  return all;
}

}  // namespace palpate::sim
