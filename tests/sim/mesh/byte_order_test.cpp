#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "sim/mesh/parse_mesh.hpp"
#include "tests/sim/mesh/fixtures.hpp"

// Gmsh writes the byte order of its machine; these files are laid out by hand after its manual, in either
// order.
namespace palpate::sim::test {
namespace {

struct BinaryFile {
  bool swapped = false;
  std::string bytes{};

  template <class Number>
  BinaryFile& put(Number value) {
    std::array<char, sizeof(Number)> buffer{};
    std::memcpy(buffer.data(), &value, sizeof(Number));
    if (swapped) std::ranges::reverse(buffer);
    bytes.append(buffer.data(), buffer.size());
    return *this;
  }
  BinaryFile& text(const std::string& words) {
    bytes += words;
    return *this;
  }
};

std::string msh2(const TetMesh& mesh, bool swapped) {
  BinaryFile file{.swapped = swapped};
  file.text("$MeshFormat\n2.2 1 8\n")
      .put(std::int32_t{1})
      .text("\n$EndMeshFormat\n$PhysicalNames\n1\n3 6 \"body\"\n");
  file.text("$EndPhysicalNames\n$Nodes\n" + std::to_string(mesh.nodes.size()) + "\n");
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    file.put(static_cast<std::int32_t>(mesh.node_tags[i]));
    for (const double x : mesh.nodes[i]) file.put(x);
  }
  file.text("\n$EndNodes\n$Elements\n" + std::to_string(mesh.tetrahedra.size()) + "\n");
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {  // blocks of one element each, with three tags
    for (const int i : {4, 1, 3, static_cast<int>(t) + 1, 6, 1, 0}) file.put(static_cast<std::int32_t>(i));
    for (const int node : mesh.tetrahedra[t]) file.put(static_cast<std::int32_t>(mesh.node_tags[node]));
  }
  return file.text("\n$EndElements\n").bytes;
}

std::string msh4(const TetMesh& mesh, bool swapped) {
  BinaryFile file{.swapped = swapped};
  const auto size = [&](std::size_t value) { file.put(static_cast<std::uint64_t>(value)); };
  const auto integer = [&](int value) { file.put(static_cast<std::int32_t>(value)); };
  file.text("$MeshFormat\n4.1 1 8\n")
      .put(std::int32_t{1})
      .text("\n$EndMeshFormat\n$PhysicalNames\n1\n3 6 \"body\"\n");
  file.text("$EndPhysicalNames\n$Entities\n");
  for (const std::size_t count : {0U, 0U, 0U, 1U}) size(count);
  integer(9);
  for (int i = 0; i < 6; ++i) file.put(0.5 * i);
  size(1);
  integer(-6);  // a group with its orientation reversed
  size(2);
  integer(1);
  integer(-2);
  file.text("\n$EndEntities\n$Nodes\n");
  for (const std::size_t value : {std::size_t{2}, mesh.nodes.size(), std::size_t{1}, mesh.nodes.size()})
    size(value);
  for (const std::size_t begin :
       {std::size_t{0}, std::size_t{5}}) {  // the second block has parameters u, v, w
    const std::size_t end = begin == 0 ? 5 : mesh.nodes.size();
    for (const int value : {3, 9, begin == 0 ? 0 : 1}) integer(value);
    size(end - begin);
    for (std::size_t i = begin; i < end; ++i) size(mesh.node_tags[i]);
    for (std::size_t i = begin; i < end; ++i) {
      for (const double x : mesh.nodes[i]) file.put(x);
      if (begin > 0) file.put(7.0).put(8.0).put(9.0);
    }
  }
  file.text("\n$EndNodes\n$Elements\n");
  for (const std::size_t value :
       {std::size_t{1}, mesh.tetrahedra.size(), std::size_t{1}, mesh.tetrahedra.size()})
    size(value);
  for (const int value : {3, 9, 4}) integer(value);
  size(mesh.tetrahedra.size());
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    size(t + 1);
    for (const int node : mesh.tetrahedra[t]) size(mesh.node_tags[node]);
  }
  return file.text("\n$EndElements\n").bytes;
}

TEST(ByteOrder, IsToldByTheMark) {
  const TetMesh cube = cube_mesh(2, 1.0 / 3.0);
  for (const bool swapped : {false, true})
    for (const std::string& bytes : {msh2(cube, swapped), msh4(cube, swapped)}) {
      const TetMesh read = parse_mesh(bytes, "body.msh", 1.0).mesh;
      EXPECT_EQ(read.nodes, cube.nodes);
      EXPECT_EQ(read.tetrahedra, cube.tetrahedra);
      EXPECT_EQ(read.node_tags, cube.node_tags);
      EXPECT_EQ(read.region_names, std::vector<std::string>{"body"});
      EXPECT_EQ(read.region, std::vector<int>(cube.tetrahedra.size(), 0));
      EXPECT_EQ(read.node_groups.at("body").size(), cube.nodes.size());
    }
}

}  // namespace
}  // namespace palpate::sim::test
