#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim::test {

/// A box [0, size] of nx x ny x nz cells, each cut into six tetrahedra along its main diagonal (Kuhn), so
/// that neighbours fit. Node (i, j, k) has index i + (nx + 1) (j + (ny + 1) k) and the tag index + 1. The
/// faces are the node groups x_min, x_max, y_min, y_max, z_min and z_max.
inline TetMesh box_mesh(int nx, int ny, int nz, const Vec3& size) {
  TetMesh mesh;
  const auto node = [&](int i, int j, int k) { return i + (nx + 1) * (j + (ny + 1) * k); };
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) {
        const int here = node(i, j, k);
        mesh.nodes.push_back(size.cwiseProduct(Vec3(double(i) / nx, double(j) / ny, double(k) / nz)));
        mesh.node_tags.push_back(here + 1);
        if (i == 0) mesh.node_groups["x_min"].push_back(here);
        if (i == nx) mesh.node_groups["x_max"].push_back(here);
        if (j == 0) mesh.node_groups["y_min"].push_back(here);
        if (j == ny) mesh.node_groups["y_max"].push_back(here);
        if (k == 0) mesh.node_groups["z_min"].push_back(here);
        if (k == nz) mesh.node_groups["z_max"].push_back(here);
      }
  // The path from corner 000 to corner 111 along the axes a, b, c; odd orders of the axes are turned inside
  // out, and so two of their nodes are exchanged.
  constexpr std::array<std::array<int, 3>, 6> paths{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        for (std::size_t path = 0; path < paths.size(); ++path) {
          std::array<int, 3> corner{i, j, k};
          Tetrahedron tetrahedron{node(i, j, k)};
          for (std::size_t step = 0; step < 3; ++step) {
            ++corner[paths[path][step]];
            tetrahedron[step + 1] = node(corner[0], corner[1], corner[2]);
          }
          if (path >= 3) std::swap(tetrahedron[1], tetrahedron[2]);
          mesh.tetrahedra.push_back(tetrahedron);
        }
  mesh.region.assign(mesh.tetrahedra.size(), -1);
  return mesh;
}

/// Nodes of any of the named groups, ascending.
inline std::vector<int> nodes_of(const TetMesh& mesh, const std::vector<std::string>& groups) {
  std::set<int> nodes;
  for (const std::string& group : groups)
    nodes.insert(mesh.node_groups.at(group).begin(), mesh.node_groups.at(group).end());
  return {nodes.begin(), nodes.end()};
}

/// Nodes of no face of the box, ascending.
inline std::vector<int> inner_nodes(const TetMesh& mesh) {
  const std::vector<int> outer = nodes_of(mesh, {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"});
  std::vector<int> all(mesh.nodes.size()), inner;
  std::iota(all.begin(), all.end(), 0);
  std::set_difference(all.begin(), all.end(), outer.begin(), outer.end(), std::back_inserter(inner));
  return inner;
}

/// Makes the mesh irregular: every inner node moves by up to `amount` [m] along each axis. Keep the amount
/// under a tenth of a cell, so that every volume stays positive.
inline TetMesh shaken(TetMesh mesh, double amount, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-amount, amount);
  for (const int node : inner_nodes(mesh))
    for (int axis = 0; axis < 3; ++axis) mesh.nodes[node][axis] += shift(random);
  return mesh;
}

}  // namespace palpate::sim::test
