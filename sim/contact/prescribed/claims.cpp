#include "sim/contact/prescribed/claims.hpp"

#include <algorithm>

namespace palpate::sim {

Claims::Claims(std::size_t touchable_nodes)
    : displacement(touchable_nodes, Vec3(Vec3::Zero())),
      squared(touchable_nodes, -1.0),
      touch_pair(touchable_nodes, -1),
      held(touchable_nodes, 0) {
  nodes.reserve(touchable_nodes);
}

void Claims::clear() {
  for (const int node : nodes) squared[node] = -1.0;
  nodes.clear();
  std::ranges::fill(held, char{0});
}

void Claims::hold(std::span<const int> probe_nodes, std::span<const double> weights) {
  for (std::size_t i = 0; i < probe_nodes.size(); ++i)
    if (weights[i] > 0.0) held[probe_nodes[i]] = 1;
}

void Claims::ask(int node, const Vec3& displacement_asked, int touch_pair_asking) {
  if (held[node]) return;
  const double length = displacement_asked.squaredNorm();
  if (length <= squared[node]) return;
  if (squared[node] < 0.0) nodes.push_back(node);
  displacement[node] = displacement_asked;
  squared[node] = length;
  touch_pair[node] = touch_pair_asking;
}

void Claims::sort() {
  std::ranges::sort(nodes);
}

}  // namespace palpate::sim
