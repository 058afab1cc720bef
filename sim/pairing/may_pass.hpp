#pragma once

#include <vector>

#include "sim/model/model.hpp"

namespace palpate::sim {

/// A polygon that a node stands before at rest, and that a polygon of the node's own faces, so that the node may come
/// to pass it. (The far side of a body follows its near side.)
struct MayPass {
  double gap = 0.0;  // between them at rest [m]; of those that touch 0
  int polygon = 0;
  bool touching = false;  // at rest: by rounding, or behind the polygon by no more than the declared overlap
};

/// The nodes of one body of a pair and the polygons of the other, at rest: what never changes of who may meet whom.
struct MeetingSides {
  int touch_pair = 0, node_body = 0, polygon_body = 0;
  double rounding = 0.0;            // what may seem apart or behind by rounding [m]
  double least_gap = 0.0;           // of all [m], infinite where no node may pass any polygon
  std::vector<double> gap{};        // of each colliding node to the nearest polygon that it may pass [m]
  std::vector<MayPass> polygons{};  // of colliding node k: [begin[k], begin[k + 1]), by gap
  std::vector<int> begin{};
};

/// For each pair of bodies the nodes of the first before the polygons of the second, then the other way round.
std::vector<MeetingSides> meeting_sides(const Model& model);

}  // namespace palpate::sim
