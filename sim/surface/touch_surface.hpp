#pragma once

#include <array>
#include <vector>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// The polygons that can collide: surface triangles all of whose nodes are touchable, by touch index, with
/// what detection needs to know about their neighbours.
struct TouchSurface {
  std::vector<Triangle> triangles{};         // touch indices, anticlockwise from outside
  std::vector<std::array<int, 3>> across{};  // triangle beyond edge (k, k+1), -1 where the patch ends
  std::vector<int> incident_begin{};         // triangles around a node: incident[incident_begin[i] .. [i+1])
  std::vector<int> incident{};
  std::vector<char> rim{};  // of each touchable node: 1 where the patch ends at it
};

/// @param triangles   the body's boundary, by mesh node
/// @param touch_of_node  touch index of each mesh node, -1 where it cannot be touched
TouchSurface make_touch_surface(const std::vector<Triangle>& triangles, const std::vector<int>& touch_of_node,
                                int touchable_nodes);

}  // namespace palpate::sim
