#include "sim/pairing/find_pairs.hpp"

#include <algorithm>
#include <limits>
#include <span>

#include "sim/pairing/swept.hpp"

namespace palpate::sim {
namespace {

/// The nodes of one body before the polygons of another, where they are.
struct Meeting {
  const MeetingSides& sides;
  const Body &nodes, &polygons;
  const PlacedBody& moved_nodes;
  PlacedBody& moved_polygons;
};

/// A node, and the polygons that may have come to it.
struct Passing {
  Vec3 rest, now;
  double reach = 0.0;  // how far it has come itself [m], rounding included
  std::span<const MayPass> polygons{};
};

/// Calls `look` on the polygons that are near enough at rest, until it returns true.
template <class Look>
bool any_in_reach(const Meeting& meeting, const Passing& node, Look look) {
  const std::vector<double>& motion = meeting.moved_polygons.polygon_motion;
  const double farthest = meeting.moved_polygons.farthest;
  for (const MayPass& may : node.polygons) {
    if (may.gap > node.reach + farthest) break;
    if (may.gap <= node.reach + motion[may.polygon] && look(may)) return true;
  }
  return false;
}

/// How deep the node is behind a polygon's plane [m].
struct Depth {
  double at_rest = 0.0;  // where the two touched or overlapped, else 0
  double since = 0.0;    // what has come since
};
Depth depth_behind(const Meeting& meeting, const Passing& node, const MayPass& may) {
  const int corner = meeting.polygons.polygons.triangles[may.polygon][0];
  const Vec3 there = meeting.moved_polygons.positions.col(corner);
  const Vec3 normal = polygon_normal(meeting.polygons, meeting.moved_polygons, may.polygon);
  const double behind = (there - node.now).dot(normal);
  if (!may.touching) return {.since = behind};
  const Vec3 rest = meeting.polygons.rest.col(corner);
  const double at_rest = (rest - node.rest).dot(meeting.moved_polygons.rest_normals.col(may.polygon));
  return {.at_rest = std::max(at_rest, 0.0), .since = behind - std::max(at_rest, 0.0)};
}

/// The polygons that the node can be as near to as to the nearest that it can have passed.
void list_passed(const Meeting& meeting, const Passing& node, std::vector<PassedPolygon>& passed) {
  passed.clear();
  const Body& body = meeting.polygons;
  const Eigen::Matrix3Xd& positions = meeting.moved_polygons.positions;
  const double rounding = meeting.sides.rounding;
  double least = std::numeric_limits<double>::infinity();
  any_in_reach(meeting, node, [&](const MayPass& may) {
    const Depth depth = depth_behind(meeting, node, may);
    if (!(depth.since > 0.0) || depth.since > least + rounding) return false;  // no nearer than the plane
    const auto [a, b, c] = body.polygons.triangles[may.polygon];
    const Vec3 nearest =
        nearest_on_triangle(node.now, positions.col(a), positions.col(b), positions.col(c)).point;
    const double distance = (nearest - node.now).norm();
    if (distance > least + rounding) return false;
    least = std::min(least, distance);
    passed.push_back({may.polygon, may.touching, distance, depth.since, depth.at_rest});
    return false;
  });
  std::erase_if(passed, [&](const PassedPolygon& polygon) { return polygon.distance > least + rounding; });
}

/// Of polygons that are all as near: the deepest passed, of those the lowest number.
const PassedPolygon& choose(std::span<const PassedPolygon> passed, double rounding) {
  const double deepest = std::ranges::max_element(passed, {}, &PassedPolygon::depth)->depth;
  const PassedPolygon* chosen = nullptr;
  for (const PassedPolygon& polygon : passed)
    if (polygon.depth >= deepest - rounding && (!chosen || polygon.polygon < chosen->polygon))
      chosen = &polygon;
  return *chosen;
}

bool goes_through(const Meeting& meeting, const Passing& node, int polygon) {
  const auto [a, b, c] = meeting.polygons.polygons.triangles[polygon];
  const Eigen::Matrix3Xd &rest = meeting.polygons.rest, &now = meeting.moved_polygons.positions;
  const SweptTriangle swept{{rest.col(a), rest.col(b), rest.col(c)}, {now.col(a), now.col(b), now.col(c)}};
  return times_entered(node.rest, node.now, swept) > 0;
}

/// Whether the node went into the surface on its way. @param first  the polygon to look at first
bool has_entered(const Meeting& meeting, const Passing& node, const PassedPolygon& first) {
  if (first.touching || goes_through(meeting, node, first.polygon)) return true;
  return any_in_reach(meeting, node, [&](const MayPass& may) {
    if (may.polygon == first.polygon) return false;
    return (may.touching && depth_behind(meeting, node, may).since > 0.0) ||
           goes_through(meeting, node, may.polygon);
  });
}

void find_colliding_nodes(const Meeting& meeting, std::vector<PassedPolygon>& passed, Pairs& pairs) {
  const MeetingSides& sides = meeting.sides;
  const double farthest = meeting.moved_polygons.farthest;
  if (sides.least_gap > meeting.moved_nodes.farthest + farthest + sides.rounding) return;
  for (std::size_t k = 0; k < sides.gap.size(); ++k) {
    const int node = meeting.nodes.colliding_nodes[k];
    const double reach = meeting.moved_nodes.motion[node] + sides.rounding;
    if (sides.gap[k] > reach + farthest) continue;
    const Passing passing{
        meeting.nodes.rest.col(node),
        meeting.moved_nodes.positions.col(node),
        reach,
        {sides.polygons.data() + sides.begin[k], sides.polygons.data() + sides.begin[k + 1]}};
    list_passed(meeting, passing, passed);
    if (passed.empty()) continue;
    const PassedPolygon& chosen = choose(passed, sides.rounding);
    if (!has_entered(meeting, passing, chosen)) continue;
    pairs.push_back({sides.touch_pair, sides.node_body, node, sides.polygon_body, chosen.polygon,
                     chosen.depth, polygon_normal(meeting.polygons, meeting.moved_polygons, chosen.polygon),
                     chosen.at_rest});
  }
}

}  // namespace

std::size_t most_pairs(const Model& model) {
  std::size_t most = 0;
  for (const TouchPair& pair : model.pairs)
    for (const int body : pair.bodies) most += model.bodies[body].colliding_nodes.size();
  return most;
}

void find_pairs(const Model& model, const FreeMotion& motion, Placement& placement, Pairs& pairs) {
  pairs.clear();
  for (const MeetingSides& sides : placement.sides) {
    if (!motion[sides.node_body].moved && !motion[sides.polygon_body].moved) continue;
    find_colliding_nodes({sides, model.bodies[sides.node_body], model.bodies[sides.polygon_body],
                          placement[sides.node_body], placement[sides.polygon_body]},
                         placement.passed, pairs);
  }
}

}  // namespace palpate::sim
