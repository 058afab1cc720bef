#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "sim/view/picture.hpp"

namespace palpate::sim::test {

/// An icosahedron whose faces are cut in four `levels` times, its nodes on a sphere: 20 x 4^levels triangles,
/// anticlockwise from outside.
inline DrawnBody ball(const Eigen::Vector3f& centre, float radius, int levels) {
  const float t = 1.6180340F;  // golden ratio
  std::vector<Eigen::Vector3f> nodes = {{-1, t, 0}, {1, t, 0}, {-1, -t, 0}, {1, -t, 0},
                                        {0, -1, t}, {0, 1, t}, {0, -1, -t}, {0, 1, -t},
                                        {t, 0, -1}, {t, 0, 1}, {-t, 0, -1}, {-t, 0, 1}};
  std::vector<Triangle> triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                     {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                     {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                     {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [found, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<int>(nodes.size()));
      if (fresh) nodes.push_back((nodes[a].normalized() + nodes[b].normalized()) / 2);
      return found->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    triangles = std::move(finer);
  }
  DrawnBody body{.name = "ball"};
  body.positions.resize(3, static_cast<Eigen::Index>(nodes.size()));
  for (Eigen::Index i = 0; i < body.positions.cols(); ++i)
    body.positions.col(i) = centre + radius * nodes[i].normalized();
  body.triangles = std::move(triangles);
  body.colour = {0.8F, 0.2F, 0.2F};
  return body;
}

}  // namespace palpate::sim::test
