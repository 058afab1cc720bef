#pragma once

#include <vector>

#include "sim/model/model.hpp"
#include "sim/surface/aabb_tree.hpp"

namespace palpate::sim {

/// In the place of a body: what does not give way, a fingertip.
inline constexpr int kRigid = -1;

/// A node of one body and the place on the surface of another that is nearest to it at rest. To first order the
/// gap between them is gap + normal . (u of the node - weighted mean of u of the corners), u the displacements.
struct FacingPair {
  int touch_pair = 0;           // index into Model::pairs; of a fingertip's, into Model::probes
  int node_body = 0, node = 0;  // body and touch index
  int polygon_body = 0;
  Triangle corners{};           // of the polygon, touch indices
  Vec3 weights = Vec3::Zero();  // of the corners, sum 1
  Vec3 normal = Vec3::UnitZ();  // unit, from the place to the node: out of the polygon's body
  double gap = 0.0;             // at rest [m], >= 0 but for rounding
};

/// On which side of the surface that it faces a node is.
enum class Faces { Nothing, Front, Back };

/// The polygon of a body at rest that is nearest to a place, no farther than `within`.
NearestPolygon nearest_of(const Body& polygons, const Vec3& place, double within);

/// Sets what the node of a pair, at `place`, faces of that polygon: corners, weights, normal and gap, in the frame of
/// the polygons' body; the gap is negative at the back. @param looks  out of the node's own surface, of any length
Faces face(const Body& polygons, const NearestPolygon& found, const Vec3& place, const Vec3& looks,
           FacingPair& pair);

/// The same where the scene puts the bodies, however far apart they are.
Faces face_at_rest(const Model& model, FacingPair& pair);

/// Whether a node at the back of what it faces at rest counts as touching it: it is no deeper than the scene declares
/// that bodies may overlap.
bool touches_at_rest(const Model& model, const FacingPair& pair);

/// Every node that can collide, of the bodies of each pair whose nodes meet polygons (TouchPair::meets), with the place that it faces. Nodes are left out whose
/// own surface looks away from that place (the far side of a body), that lie behind it (beyond the body's wall), or that face the rim of a touchable patch, beyond
/// which the surface is not known. Order: touch pairs as in the model; the nodes of the first body, then of the
/// second, ascending.
std::vector<FacingPair> facing_pairs(const Model& model);

}  // namespace palpate::sim
