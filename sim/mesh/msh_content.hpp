#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/mesh/cursor.hpp"
#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// A first-order element of an MSH file: point, line, triangle or tetrahedron (dimension 0 to 3).
struct MshElement {
  int dimension = 0;
  std::int64_t entity = 0;                  // MSH 4.1: entity tag; MSH 2.2: physical tag
  std::array<std::int64_t, 4> node_tags{};  // dimension + 1 of them
  std::size_t offset = 0;                   // where it stands in the file [byte]
};

using DimensionAndTag = std::pair<int, std::int64_t>;

/// What the sections of an MSH file say, before tags are resolved.
struct MshContent {
  std::vector<std::int64_t> node_tags;
  std::vector<Vec3> nodes;       // file's unit
  std::size_t nodes_offset = 0;  // where $Nodes stands in the file [byte]
  std::vector<MshElement> elements;
  std::map<DimensionAndTag, std::vector<std::int64_t>> physicals;  // of an entity (dimension, tag)
  std::map<DimensionAndTag, std::string> names;                    // of a physical group (dimension, tag)
  std::vector<std::string> passed_over;                            // sections that are not read: "$Comments"
};

/// Dimension of Gmsh's element type `type`; refuses all but points, lines, triangles and tetrahedra of first
/// order, with what to do about it.
int msh_dimension(const Cursor& in, std::int64_t type);

void read_msh2_nodes(Cursor& in, MshContent& content);
void read_msh2_elements(Cursor& in, MshContent& content);
void read_msh4_entities(Cursor& in, MshContent& content);
void read_msh4_nodes(Cursor& in, MshContent& content);
void read_msh4_elements(Cursor& in, MshContent& content);

/// Resolves tags: tetrahedra as node indices, named groups as nodes and regions. Node order is the file's. A
/// tetrahedron in several named volume groups counts to the smallest: a nodule lies within the body around
/// it.
TetMesh assemble(const Cursor& in, const MshContent& content);

}  // namespace palpate::sim
