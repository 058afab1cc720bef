#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// Displacements asked of touchable nodes of one body, beyond where its probes alone bring them. A node that
/// is asked twice takes the larger displacement, of two alike the first; a node that a pressing probe holds
/// stays with the probe.
struct Claims {
  std::vector<Vec3> displacement;  // of each touchable node [m]
  std::vector<double> squared;     // its squared length, -1 where nothing is asked
  std::vector<int> touch_pair;     // that asked
  std::vector<char> held;          // 1: held by a probe that presses
  std::vector<int> nodes;          // that are asked, ascending once sort() is called

  explicit Claims(std::size_t touchable_nodes);
  void clear();
  /// Those of a pressing probe with a weight > 0.
  void hold(std::span<const int> probe_nodes, std::span<const double> weights);
  void ask(int node, const Vec3& displacement_asked, int touch_pair_asking);
  void sort();
};

}  // namespace palpate::sim
