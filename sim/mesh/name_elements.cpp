#include "sim/mesh/name_elements.hpp"

#include <fmt/format.h>

namespace palpate::sim {

std::int64_t node_tag(const TetMesh& mesh, int node) {
  const std::size_t index = node;
  return index < mesh.node_tags.size() ? mesh.node_tags[index] : node;
}

std::string name_edge(const TetMesh& mesh, int a, int b) {
  return fmt::format("edge {}-{}", node_tag(mesh, a), node_tag(mesh, b));
}

std::string name_tetrahedron(const TetMesh& mesh, int tetrahedron) {
  const Tetrahedron& nodes = mesh.tetrahedra[tetrahedron];
  return fmt::format("tetrahedron {} (nodes {}, {}, {}, {})", tetrahedron, node_tag(mesh, nodes[0]),
                     node_tag(mesh, nodes[1]), node_tag(mesh, nodes[2]), node_tag(mesh, nodes[3]));
}

}  // namespace palpate::sim
