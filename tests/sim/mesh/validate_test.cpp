#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/mesh/parse_mesh.hpp"
#include "sim/mesh/quality.hpp"
#include "tests/sim/mesh/fixtures.hpp"

namespace palpate::sim::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string complaint(const TetMesh& mesh) {
  try {
    validate(mesh);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// Tetrahedra on given points, each made positive; tags count from 1.
TetMesh mesh_of(const std::vector<Vec3>& nodes, const std::vector<Tetrahedron>& tetrahedra) {
  TetMesh mesh{.nodes = nodes,
               .tetrahedra = tetrahedra,
               .region = {},
               .region_names = {},
               .node_groups = {},
               .node_tags = {}};
  mesh.region.assign(tetrahedra.size(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) mesh.node_tags.push_back(static_cast<std::int64_t>(i) + 1);
  return mend(mesh, "made", 1.0).mesh;
}

TEST(Validate, AcceptsSoundBodies) {
  EXPECT_EQ(complaint(cube_mesh(3, 0.1)), "");
  TetMesh far = cube_mesh(3, 1e-3);  // a millimetre body, 10 km away: rounding must not make it flat
  for (Vec3& x : far.nodes) x += Vec3::Constant(1e4);
  EXPECT_EQ(complaint(far), "");
}

TEST(Validate, AcceptsSeveralPieces) {
  EXPECT_EQ(complaint(mesh_of(
                {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1}},
                {{0, 1, 2, 3}, {4, 5, 6, 7}})),
            "");
}

TEST(Validate, RefusesNothing) {
  EXPECT_THAT(complaint({}), HasSubstr("has no tetrahedron"));
}

TEST(Validate, RefusesFlatTetrahedra) {
  EXPECT_THAT(complaint(mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}})),
              AllOf(HasSubstr("tetrahedra without volume: tetrahedron 0 (nodes 1, 2, 3, 4)"),
                    HasSubstr("mesh again")));
  const double sliver = 1e-6;  // a sliver keeps a volume and is only warned of
  EXPECT_EQ(complaint(mesh_of({{0, 0, 0}, {1, 0, sliver}, {1, 1, 0}, {0, 1, sliver}}, {{0, 1, 2, 3}})), "");
}

TEST(Validate, RefusesEdgesThatJoinTwoParts) {
  EXPECT_THAT(complaint(mesh_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}},
                                {{0, 1, 2, 3}, {0, 1, 4, 5}})),
              AllOf(HasSubstr("not a manifold: edge 1-2 (4 triangles)"), HasSubstr("exactly two triangles")));
}

TEST(Validate, RefusesNodesThatJoinTwoParts) {
  EXPECT_THAT(
      complaint(mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
                        {{0, 1, 2, 3}, {0, 4, 5, 6}})),
      HasSubstr("meet in one node alone: node 1;"));
}

TEST(Validate, RefusesThreeTetrahedraOnAFace) {
  EXPECT_THAT(complaint(mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {1, 1, 1}},
                                {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}})),
              HasSubstr("face 1-2-3 (3 tetrahedra)"));
}

// One node pulled through the opposite face: no order of nodes mends that, for the tetrahedra then overlap.
TEST(Validate, RefusesTetrahedraTurnedInsideOut) {
  TetMesh cube = cube_mesh(2, 1.0);
  cube.nodes[13] = Vec3(1.4, 0.5, 0.5);  // the centre, moved out of the cube
  EXPECT_THAT(complaint(mend(cube, "made", 1.0).mesh),
              AllOf(HasSubstr("tetrahedra overlap, lying on the same side of a common face: tetrahedron"),
                    HasSubstr("cannot be mended by the order of their nodes")));
}

TEST(Validate, NamesNoMoreThanAFewElements) {
  TetMesh flat = cube_mesh(2, 1.0);
  for (Vec3& x : flat.nodes) x.z() = 0.0;
  EXPECT_THAT(complaint(flat), HasSubstr(" and 43 more"));  // five of 48 by name
}

}  // namespace
}  // namespace palpate::sim::test
