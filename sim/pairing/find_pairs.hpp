#pragma once

#include <vector>

#include "sim/model/free_state.hpp"
#include "sim/model/model.hpp"
#include "sim/pairing/placement.hpp"

namespace palpate::sim {

/// A node of one body that has passed a polygon of another.
struct CollidingPair {
  int touch_pair = 0;           // index into Model::pairs
  int node_body = 0, node = 0;  // body and touch index
  int polygon_body = 0, polygon = 0;
  double depth = 0.0;          // of the node behind the polygon's plane, less what it was at rest [m], > 0
  Vec3 normal = Vec3::Zero();  // outward, of the polygon
  double depth_at_rest = 0.0;  // of a pair that overlaps at rest, as the scene declares [m]
};
using Pairs = std::vector<CollidingPair>;

/// Largest number of pairs that find_pairs can return.
std::size_t most_pairs(const Model& model);

/// Node-polygon detection between the surfaces where place() has brought them, swept from rest. It depends on that
/// pose alone.
/// A node *can have passed* a polygon when it stood before it at rest (or touched it, or overlapped it by no more
/// than the scene declares), is behind its plane now, and was no farther from it than both have moved. It *has
/// passed* when, on the straight way of both from rest, it has gone into the surface through one of the polygons
/// that it stood before. It then collides with the nearest polygon of those that it can have passed; of several as
/// near, within rounding, with the one whose plane it is deepest behind; of those as deep, with the lowest number.
/// Order: touch pairs as in the model; the nodes of its first body, then of its second, ascending. `pairs` keeps its
/// capacity: no allocation once it holds most_pairs(model).
void find_pairs(const Model& model, const FreeMotion& motion, Placement& placement, Pairs& pairs);

}  // namespace palpate::sim
