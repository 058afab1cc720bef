#include "sim/mesh/read_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/mesh/parse_mesh.hpp"
#include "sim/mesh/quality.hpp"
#include "sim/mesh/volume.hpp"
#include "tests/sim/mesh/fixtures.hpp"

namespace palpate::sim::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Key;

/// Nodes for which `wanted` holds: groups by geometry, independent of how a reader finds them.
template <class Wanted>
std::vector<int> nodes_where(const TetMesh& mesh, Wanted wanted) {
  std::vector<int> nodes;
  for (int i = 0; i < static_cast<int>(mesh.nodes.size()); ++i)
    if (wanted(mesh.nodes[i])) nodes.push_back(i);
  return nodes;
}

class TwoBoxes : public testing::TestWithParam<std::string> {};

// Volume and area are those of two unit cubes side by side; node and element counts stand in the files'
// headers.
TEST_P(TwoBoxes, IsReadAsItWasMade) {
  const MeshFile read = read_mesh(data_file(GetParam()), 1.0);
  const TetMesh& mesh = read.mesh;
  EXPECT_EQ(mesh.nodes.size(), 23U);
  EXPECT_EQ(mesh.tetrahedra.size(), 48U);
  EXPECT_EQ(mesh.region.size(), 48U);
  EXPECT_EQ(read.repairs.reordered_tetrahedra, 0);
  EXPECT_EQ(read.repairs.welded_nodes, 0);
  EXPECT_EQ(read.repairs.unreferenced_nodes, 0);
  double volume = 0.0;
  for (const Tetrahedron& t : mesh.tetrahedra) {
    EXPECT_GT(signed_volume(mesh, t), 0.0);
    volume += signed_volume(mesh, t);
  }
  EXPECT_NEAR(volume, 2.0, 1e-14);  // sums of 48 products of small binary fractions
  EXPECT_NO_THROW(validate(mesh));
  EXPECT_EQ(mesh.node_groups.at("fixed"), nodes_where(mesh, [](const Vec3& x) { return x.x() == 0.0; }));
}

TEST_P(TwoBoxes, SplitsRegionsAtTheBoxesCommonFace) {
  const TetMesh mesh = read_mesh(data_file(GetParam()), 1.0).mesh;
  const bool is_msh = GetParam().ends_with(".msh");
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    double x = 0.0;
    for (const int node : mesh.tetrahedra[t]) x += mesh.nodes[node].x() / 4;
    const std::string left = is_msh ? "all" : "none", right = is_msh ? "right" : "7";
    const std::string region = mesh.region[t] < 0 ? "none" : mesh.region_names[mesh.region[t]];
    EXPECT_EQ(region, x < 1.0 ? left : right) << "tetrahedron " << t;
  }
}

TEST_P(TwoBoxes, ScalesWithTheUnit) {
  const TetMesh metres = read_mesh(data_file(GetParam()), 1.0).mesh;
  const TetMesh millimetres = read_mesh(data_file(GetParam()), 1e-3).mesh;
  for (std::size_t i = 0; i < metres.nodes.size(); ++i)
    EXPECT_EQ(millimetres.nodes[i], Vec3(1e-3 * metres.nodes[i]));
}

INSTANTIATE_TEST_SUITE_P(Encodings, TwoBoxes, testing::ValuesIn(two_boxes_files()), [](const auto& file) {
  std::string name = file.param;
  std::ranges::replace(name, '.', '_');
  return name;
});

class MshGroups : public testing::TestWithParam<std::string> {};

TEST_P(MshGroups, AreKeptInEveryDimension) {
  const TetMesh mesh = read_mesh(data_file(GetParam()), 1.0).mesh;
  EXPECT_THAT(mesh.node_groups, ElementsAre(Key("all"), Key("corner"), Key("edge of the left end"),
                                            Key("ends"), Key("fixed"), Key("right")));
  EXPECT_THAT(mesh.region_names, ElementsAre("all", "right"));
  const auto expect = [&](const char* name, auto wanted) {
    EXPECT_EQ(mesh.node_groups.at(name), nodes_where(mesh, wanted)) << name;
  };
  expect("all", [](const Vec3&) { return true; });
  expect("right", [](const Vec3& x) { return x.x() >= 1.0; });
  // Gmsh numbers the top of the right box 11
  expect("ends", [](const Vec3& x) { return x.x() == 0.0 || (x.x() >= 1.0 && x.z() == 1.0); });
  expect("edge of the left end", [](const Vec3& x) { return x.x() == 0.0 && x.y() == 0.0; });
  expect("corner", [](const Vec3& x) { return x == Vec3(0, 0, 1); });
}

TEST_P(MshGroups, KeepNodeTags) {
  const TetMesh mesh = read_mesh(data_file(GetParam()), 1.0).mesh;
  const auto at = std::ranges::find(mesh.node_tags, 11) - mesh.node_tags.begin();
  EXPECT_EQ(mesh.nodes.at(at), Vec3(2, 1, 1));  // "11 2 1 1" in the file
}

INSTANTIATE_TEST_SUITE_P(Versions, MshGroups,
                         testing::Values("two_boxes.v22.text.msh", "two_boxes.v22.binary.msh",
                                         "two_boxes.v41.text.msh", "two_boxes.v41.binary.msh"),
                         [](const auto& file) {
                           return file.param.substr(10, 3) + file.param.substr(14, 4);
                         });

TEST(ReadMesh, AcceptsCarriageReturnsAndAByteOrderMark) {
  for (const char* name :
       {"two_boxes.v22.text.msh", "two_boxes.v41.text.msh", "two_boxes.ascii.plain.uint32.little.vtu"}) {
    std::string windows = "\xef\xbb\xbf";
    for (const char c : read_bytes(data_file(name)))
      windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    const TetMesh mesh = parse_mesh(windows, name, 1.0).mesh;
    EXPECT_EQ(mesh.tetrahedra, read_mesh(data_file(name), 1.0).mesh.tetrahedra) << name;
    EXPECT_EQ(mesh.node_groups, read_mesh(data_file(name), 1.0).mesh.node_groups) << name;
  }
}

TEST(ReadMesh, TakesTagsWithGapsInAnyOrder) {
  TetMesh cube = cube_mesh(1, 1.0);
  cube.node_tags = {900, 17, 1, 88, 1000000000000, 5, 4, 3};
  const TetMesh read = parse_mesh(to_msh2(cube), "body.msh", 1.0).mesh;
  EXPECT_EQ(read.node_tags, cube.node_tags);
  EXPECT_EQ(read.tetrahedra, cube.tetrahedra);
}

TEST(ReadMesh, KeepsAGroupThatIsDeclaredButEmpty) {
  const std::string text = replaced(to_msh2(cube_mesh(1, 1.0)), "$Nodes",
                                    "$PhysicalNames\n1\n2 4 \"touch\"\n$EndPhysicalNames\n$Nodes");
  EXPECT_TRUE(parse_mesh(text, "body.msh", 1.0).mesh.node_groups.at("touch").empty());
}

TEST(ReadMesh, PassesOverSectionsThatABodyDoesNotNeed) {
  const std::string text = replaced(to_msh2(cube_mesh(1, 1.0)), "$Nodes",
                                    "$Comments\nmade by hand, 1,5 times\n$EndComments\n$Nodes");
  EXPECT_EQ(parse_mesh(text, "body.msh", 1.0).mesh.nodes.size(), 8U);
}

}  // namespace
}  // namespace palpate::sim::test
