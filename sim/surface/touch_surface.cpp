#include "sim/surface/touch_surface.hpp"

#include <map>
#include <utility>

namespace palpate::sim {
namespace {

/// Fills `across` and `rim`: a directed edge of one triangle runs the other way in its neighbour.
void connect(TouchSurface& surface) {
  std::map<std::pair<int, int>, std::pair<int, int>> edges;  // (from, to) -> (triangle, edge)
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    const Triangle& nodes = surface.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) edges[{nodes[k], nodes[(k + 1) % 3]}] = {t, static_cast<int>(k)};
  }
  for (const auto& [edge, place] : edges) {
    const auto opposite = edges.find({edge.second, edge.first});
    int& neighbour = surface.across[place.first][place.second];
    neighbour = opposite == edges.end() ? -1 : opposite->second.first;
    if (neighbour < 0) {
      surface.rim[edge.first] = 1;
      surface.rim[edge.second] = 1;
    }
  }
}

void list_incident(TouchSurface& surface, int nodes) {
  surface.incident_begin.assign(nodes + 1, 0);
  for (const Triangle& triangle : surface.triangles)
    for (const int node : triangle) ++surface.incident_begin[node + 1];
  for (std::size_t i = 1; i < surface.incident_begin.size(); ++i)
    surface.incident_begin[i] += surface.incident_begin[i - 1];
  surface.incident.resize(3 * surface.triangles.size());
  std::vector<int> next(surface.incident_begin.begin(), surface.incident_begin.end() - 1);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const int node : surface.triangles[t]) surface.incident[next[node]++] = static_cast<int>(t);
}

}  // namespace

TouchSurface make_touch_surface(const std::vector<Triangle>& triangles, const std::vector<int>& touch_of_node,
                                int touchable_nodes) {
  TouchSurface surface;
  for (const Triangle& triangle : triangles) {
    Triangle touch{};
    for (std::size_t k = 0; k < 3; ++k) touch[k] = touch_of_node[triangle[k]];
    if (touch[0] >= 0 && touch[1] >= 0 && touch[2] >= 0) surface.triangles.push_back(touch);
  }
  surface.across.assign(surface.triangles.size(), {-1, -1, -1});
  surface.rim.assign(touchable_nodes, 0);
  connect(surface);
  list_incident(surface, touchable_nodes);
  return surface;
}

}  // namespace palpate::sim
