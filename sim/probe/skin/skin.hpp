#pragma once

#include <functional>
#include <map>
#include <set>
#include <vector>

#include "sim/mesh/surface.hpp"
#include "sim/mesh/tet_mesh.hpp"
#include "sim/scene/scene.hpp"

namespace palpate::sim {

/// The surface of a body as a probe finds its way on it, by mesh node.
struct Skin {
  const TetMesh& mesh;
  std::map<int, std::vector<int>> neighbours{};  // of each surface node, itself too
  std::map<int, double> area{};                  // its share of the surface [m^2]
  std::map<int, Vec3> outward{};                 // sum of twice the area vectors around it
};
Skin skin_of(const TetMesh& mesh, const Surface& surface);

/// Nodes that `within` accepts and that are reached from the middle along edges of the surface between such nodes.
std::set<int> connected(const Skin& skin, int middle, const std::function<bool(int)>& within);

/// How far a node is from the line of the press through the middle [m].
double across(const ProbeSpec& spec, const TetMesh& mesh, int middle, int node);

/// Throws RefusedKey where a probe's radius does not reach the nodes beside its middle.
void refuse_smaller_than_mesh(const ProbeSpec& spec, const Skin& skin, int middle);

}  // namespace palpate::sim
