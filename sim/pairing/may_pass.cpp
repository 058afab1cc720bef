#include "sim/pairing/may_pass.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "sim/pairing/outward.hpp"

namespace palpate::sim {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Adds the polygons that a place at rest stands before.
/// @param overlap  that is declared [m]
void list_polygons(const Body& body, const Vec3& place, double overlap, double rounding,
                   std::vector<MayPass>& list) {
  const auto& triangles = body.polygons.triangles;
  for (int polygon = 0; polygon < std::ssize(triangles); ++polygon) {
    const auto [a, b, c] = triangles[polygon];
    const double behind =
        (Vec3(body.rest.col(a)) - place).dot(area_vector(triangles[polygon], body.rest).normalized());
    if (behind > overlap + rounding) continue;
    const Vec3 nearest =
        nearest_on_triangle(place, body.rest.col(a), body.rest.col(b), body.rest.col(c)).point;
    const double gap = (nearest - place).norm();
    const bool touching = behind >= -rounding && gap <= overlap + rounding;
    if (touching || behind <= rounding) list.push_back({gap, polygon, touching});
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
  for (const int node : nodes.colliding_nodes) {
    const int first = sides.begin.back();
    list_polygons(polygons, nodes.rest.col(node), model.overlap, sides.rounding, sides.polygons);
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
