#include "sim/mesh/surface.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "tests/sim/mesh/fixtures.hpp"
#include "tests/sim/support/box_mesh.hpp"

namespace palpate::sim::test {
namespace {

TEST(Surface, OfACubeIsClosedAndSeenFromOutside) {
  constexpr int kN = 4;
  const TetMesh cube = cube_mesh(kN, 2.0);
  const Surface surface = extract_surface(cube);
  EXPECT_EQ(surface.triangles.size(), 6U * 2U * kN * kN);  // two a square
  EXPECT_EQ(surface.nodes.size(),
            std::size_t{(kN + 1) * (kN + 1) * (kN + 1) - (kN - 1) * (kN - 1) * (kN - 1)});
  EXPECT_TRUE(std::ranges::is_sorted(surface.nodes));

  std::map<std::pair<int, int>, int> sides;
  double area = 0.0;
  for (const Triangle& t : surface.triangles) {
    const auto at = [&](std::size_t i) -> const Vec3& { return cube.nodes[t[i]]; };
    const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0));
    EXPECT_GT(normal.dot(at(0) - Vec3(1, 1, 1)), 0.0);  // the cube is convex: away from its centre
    area += normal.norm() / 2.0;
    for (std::size_t i = 0; i < 3; ++i) ++sides[{t[i], t[(i + 1) % 3]}];
  }
  EXPECT_NEAR(area, 24.0, 1e-12);
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(sides.count({side.second, side.first}), 1U);  // its neighbour runs along it the other way
  }
}

TEST(Surface, EnclosesTheVolumeByTheDivergenceTheorem) {
  EXPECT_NEAR(enclosed_volume(cube_mesh(3, 2.0)), 8.0, 1e-13);
  EXPECT_NEAR(enclosed_volume(read_mesh(data_file("two_boxes.v41.text.msh"), 1.0).mesh), 2.0, 1e-14);
}

TEST(Surface, TellsWhichTetrahedronIsBehindATriangle) {
  const TetMesh mesh = test::box_mesh(2, 2, 2, Vec3(1, 1, 1));
  const Surface surface = extract_surface(mesh);
  ASSERT_EQ(surface.behind.size(), surface.triangles.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (const int node : surface.triangles[i])
      EXPECT_EQ(std::ranges::count(mesh.tetrahedra[surface.behind[i]], node), 1);
}

TEST(Surface, OfNothingIsEmpty) {
  EXPECT_TRUE(extract_surface({}).triangles.empty());
}

}  // namespace
}  // namespace palpate::sim::test
