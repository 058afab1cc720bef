#include <gtest/gtest.h>

#include <utility>

#include "sim/mesh/parse_mesh.hpp"
#include "sim/mesh/quality.hpp"
#include "sim/mesh/volume.hpp"
#include "tests/sim/mesh/fixtures.hpp"

namespace palpate::sim::test {
namespace {

TEST(Mend, LeavesASoundMeshAlone) {
  const TetMesh cube = cube_mesh(3, 1.0);
  const MeshFile mended = mend(cube, "cube", 1.0);
  EXPECT_EQ(mended.mesh.tetrahedra, cube.tetrahedra);
  EXPECT_EQ(mended.mesh.nodes, cube.nodes);
  EXPECT_EQ(
      mended.repairs.reordered_tetrahedra + mended.repairs.welded_nodes + mended.repairs.unreferenced_nodes,
      0);
  EXPECT_NEAR(mended.repairs.weld_tolerance, 1e-9 * std::sqrt(3.0), 1e-24);
}

TEST(Mend, ReordersNegativeVolumesAndCountsThem) {
  TetMesh cube = cube_mesh(2, 1.0);
  for (const std::size_t t : {0U, 7U, 41U}) std::swap(cube.tetrahedra[t][0], cube.tetrahedra[t][1]);
  const MeshFile mended = mend(cube, "cube", 1.0);
  EXPECT_EQ(mended.repairs.reordered_tetrahedra, 3);
  for (const Tetrahedron& t : mended.mesh.tetrahedra) EXPECT_GT(signed_volume(mended.mesh, t), 0.0);
  EXPECT_NO_THROW(validate(mended.mesh));
}

/// The cube's last tetrahedron on four nodes of its own, moved by `distance` in x.
TetMesh with_duplicates(double distance) {
  TetMesh cube = cube_mesh(1, 1.0);
  for (int& node : cube.tetrahedra.back()) {
    cube.node_groups["touch"].push_back(static_cast<int>(cube.nodes.size()));
    cube.nodes.push_back(cube.nodes[node] + Vec3(distance, 0, 0));
    cube.node_tags.push_back(static_cast<std::int64_t>(cube.nodes.size()));
    node = static_cast<int>(cube.nodes.size()) - 1;
  }
  return cube;
}

TEST(Mend, WeldsDuplicatesWithinTheTolerance) {
  const TetMesh whole = cube_mesh(1, 1.0);
  for (const double distance : {0.0, 1e-12, 1.7e-9}) {  // the tolerance is 1e-9 of the diagonal: 1.73e-9
    const MeshFile mended = mend(with_duplicates(distance), "cube", 1.0);
    EXPECT_EQ(mended.repairs.welded_nodes, 4) << distance;
    EXPECT_EQ(mended.mesh.tetrahedra, whole.tetrahedra) << distance;
    EXPECT_EQ(mended.mesh.node_tags, whole.node_tags) << distance;
    std::vector<int> expected(whole.tetrahedra.back().begin(), whole.tetrahedra.back().end());
    std::ranges::sort(expected);
    EXPECT_EQ(mended.mesh.node_groups.at("touch"), expected) << distance;
  }
}

TEST(Mend, KeepsNodesApartBeyondTheTolerance) {
  const MeshFile mended = mend(with_duplicates(2e-9), "cube", 1.0);
  EXPECT_EQ(mended.repairs.welded_nodes, 0);
  EXPECT_EQ(mended.mesh.nodes.size(), 12U);
}

TEST(Mend, WeldsTheSameFarFromTheOrigin) {
  TetMesh far = with_duplicates(0.0);
  for (Vec3& x : far.nodes) x += Vec3(1e4, -1e4, 1e4);
  EXPECT_EQ(mend(far, "cube", 1.0).repairs.welded_nodes, 4);
}

TEST(Mend, LeavesOutUnreferencedNodesAlsoFromGroups) {
  TetMesh cube = cube_mesh(1, 1.0);
  cube.nodes.insert(cube.nodes.begin(),
                    Vec3(5, 5, 5));  // a construction point, first so that every index moves
  cube.node_tags.insert(cube.node_tags.begin(), 77);
  for (Tetrahedron& t : cube.tetrahedra)
    for (int& node : t) ++node;
  cube.node_groups["points"] = {0, 3};
  const MeshFile mended = mend(cube, "cube", 1.0);
  EXPECT_EQ(mended.repairs.unreferenced_nodes, 1);
  EXPECT_EQ(mended.mesh.nodes, cube_mesh(1, 1.0).nodes);
  EXPECT_EQ(mended.mesh.node_groups.at("points"), std::vector<int>{2});
  EXPECT_NEAR(mended.repairs.weld_tolerance, 1e-9 * std::sqrt(3.0), 1e-24);  // the stray point has no say
}

TEST(Mend, KeepsAGroupOnDuplicatesThatNoTetrahedronUses) {
  TetMesh cube = cube_mesh(1, 1.0);  // as when a surface was meshed on its own and joined to the body
  cube.node_groups["touch"] = {8};
  cube.nodes.push_back(cube.nodes[5]);
  cube.node_tags.push_back(9);
  const MeshFile mended = mend(cube, "cube", 1.0);
  EXPECT_EQ(mended.repairs.welded_nodes, 1);
  EXPECT_EQ(mended.repairs.unreferenced_nodes, 0);
  EXPECT_EQ(mended.mesh.node_groups.at("touch"), std::vector<int>{5});
}

}  // namespace
}  // namespace palpate::sim::test
