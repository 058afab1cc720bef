#pragma once

#include <cstdint>
#include <vector>

#include "sim/model/free_state.hpp"
#include "sim/pairing/may_pass.hpp"

namespace palpate::sim {

/// A body where its motion has brought it.
struct PlacedBody {
  Eigen::Matrix3Xd positions{};          // of the touchable nodes: rest + displacement, 3 x t [m]
  std::vector<double> motion{};          // how far each of them has come from rest [m]
  std::vector<double> polygon_motion{};  // and the farthest corner of each polygon [m]
  double farthest = 0.0;                 // the largest motion of a node that can collide [m]
  bool moved = false;                    // false: at rest
  Eigen::Matrix3Xd rest_normals{};       // of the polygons at rest, outward, unit length
  Eigen::Matrix3Xd normals{};         // of those polygons that polygon_normal() was asked for since place()
  std::vector<std::uint64_t> made{};  // when: the count of place() then
  std::uint64_t count = 0;            // of calls of place()
};

/// A polygon that a node can have passed, and lies behind.
struct PassedPolygon {
  int polygon = 0;
  bool touching = false;  // at rest
  double distance = 0.0;  // from the node [m]
  double depth = 0.0;     // of the node behind the polygon's plane, less what it was at rest [m]
  double at_rest = 0.0;   // what it was at rest: the overlap that a scene declares [m]
};

/// All that detection needs, made once for a model: what is known at rest, and the bodies where they are now.
struct Placement {
  std::vector<PlacedBody> bodies{};
  std::vector<MeetingSides> sides{};
  std::vector<PassedPolygon> passed{};  // room for those of one node

  PlacedBody& operator[](std::size_t body) { return bodies[body]; }
  const PlacedBody& operator[](std::size_t body) const { return bodies[body]; }
};

/// The bodies at rest, with room for all that place() and find_pairs() will write.
Placement rest_placement(const Model& model);

/// Brings the bodies where their displacements put them.
void place(const Model& model, const FreeMotion& motion, Placement& placement);

/// Outward unit normal of a polygon where it is now.
Vec3 polygon_normal(const Body& body, PlacedBody& placed, int polygon);

}  // namespace palpate::sim
