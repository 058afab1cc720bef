#pragma once

#include <vector>

#include "sim/model/free_state.hpp"
#include "sim/model/model.hpp"

namespace palpate::sim {

/// The polygons of a body where its motion has brought them.
struct PlacedBody {
  Eigen::Matrix3Xd positions{};  // of the touchable nodes: rest + displacement, 3 x t [m]
  AabbTree tree{};               // over the polygons there
  bool moved = false;            // false: at rest, and the body's own tree holds
};
using Placement = std::vector<PlacedBody>;  // one a body

/// A node of one body that has passed a polygon of another.
struct CollidingPair {
  int touch_pair = 0;           // index into Model::pairs
  int node_body = 0, node = 0;  // body and touch index
  int polygon_body = 0, polygon = 0;
  double depth = 0.0;          // of the node behind the polygon's plane [m], > 0
  Vec3 normal = Vec3::Zero();  // outward, of the polygon
};
using Pairs = std::vector<CollidingPair>;

/// The bodies at rest, with room for all that place() will write.
Placement rest_placement(const Model& model);

/// Sets positions and trees from the displacements of the bodies that moved; the others are at rest.
void place(const Model& model, const FreeMotion& motion, Placement& placement);

/// Largest number of pairs that find_pairs can return.
std::size_t most_pairs(const Model& model);

/// Node-polygon detection between the deformed surfaces. A node collides with the polygon nearest to it when
/// it lies behind the surface there (sign of the angle-weighted normal of face, edge or corner,
/// [Baerentzen2005]) and the nearest place is not on the rim of the touchable patch. Only polygons that a
/// node can have reached by the motion from rest are looked at, so the search needs no distance chosen by
/// hand. Bodies are apart at rest (compile() sees to it). Order: touch pairs as in the model; the nodes of
/// its first body, then of its second, ascending. `pairs` keeps its capacity: no allocation once it holds
/// most_pairs(model).
void find_pairs(const Model& model, const FreeMotion& motion, const Placement& placement, Pairs& pairs);

/// Outward unit normal of a polygon.
Vec3 polygon_normal(const Body& body, const PlacedBody& placed, int polygon);

/// Deepest overlap of each pair of bodies that may touch [m], 0 where there is none. Outside the cycle.
std::vector<double> deepest_overlaps(const Model& model, const FreeMotion& motion,
                                     const Placement& placement);

}  // namespace palpate::sim
