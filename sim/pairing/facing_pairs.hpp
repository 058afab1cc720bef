#pragma once

#include <vector>

#include "sim/model/model.hpp"

namespace palpate::sim {

/// A node of one body and the place on the surface of another that is nearest to it at rest. To first order the
/// gap between them is gap + normal . (u of the node - weighted mean of u of the corners), u the displacements.
struct FacingPair {
  int touch_pair = 0;           // index into Model::pairs
  int node_body = 0, node = 0;  // body and touch index
  int polygon_body = 0;
  Triangle corners{};           // of the polygon, touch indices
  Vec3 weights = Vec3::Zero();  // of the corners, sum 1
  Vec3 normal = Vec3::UnitZ();  // unit, from the place to the node: out of the polygon's body
  double gap = 0.0;             // at rest [m], >= 0 but for rounding
};

/// Where a body's rest has been brought: R x + shift.
struct RigidPose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();
};

/// On which side of the surface that it faces a node is.
enum class Faces { Nothing, Front, Back };

/// Finds what the node of a pair faces of the other body's surface, no farther than `within`: sets corners, weights,
/// normal and gap, in the frame of the polygons' body; the gap is negative at the back.
/// @param pose  of the nodes' body, as that of the polygons sees it
Faces face(const Body& nodes, const Body& polygons, const RigidPose& pose, double within, FacingPair& pair);

/// Whether a node at the back of what it faces at rest counts as touching it: it is no deeper than the scene declares
/// that bodies may overlap.
bool touches_at_rest(const Model& model, const FacingPair& pair);

/// Every node that can collide, of the bodies of each pair whose nodes meet polygons (TouchPair::meets), with the place that it faces. Nodes are left out whose
/// own surface looks away from that place (the far side of a body), that lie behind it (beyond the body's wall), or that face the rim of a touchable patch, beyond
/// which the surface is not known. Order: touch pairs as in the model; the nodes of the first body, then of the
/// second, ascending.
std::vector<FacingPair> facing_pairs(const Model& model);

}  // namespace palpate::sim
