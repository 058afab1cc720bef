#include "sim/mesh/quality.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/mesh/fixtures.hpp"

namespace palpate::sim::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TetMesh one_tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return {.nodes = {a, b, c, d},
          .tetrahedra = {{0, 1, 2, 3}},
          .region = {-1},
          .region_names = {},
          .node_groups = {},
          .node_tags = {11, 12, 13, 14}};
}

TEST(Quality, OfTheRegularTetrahedron) {
  const double h = 0.1;  // inscribed in a cube of side h
  const MeshQuality q = measure_quality(one_tetrahedron({0, 0, 0}, {h, h, 0}, {h, 0, h}, {0, h, h}));
  const TetMesh mirrored = one_tetrahedron({0, 0, 0}, {h, 0, h}, {h, h, 0}, {0, h, h});
  const MeshQuality m = measure_quality(mirrored);
  const double volume = h * h * h / 3.0;
  EXPECT_NEAR(std::abs(q.volume), volume, 1e-18);
  EXPECT_NEAR(q.volume, -m.volume, 1e-18);
  for (const MeshQuality& one : {q.volume > 0 ? q : m}) {
    EXPECT_NEAR(one.min_dihedral, std::acos(1.0 / 3.0) * 180 / M_PI, 1e-9);  // 70.5288 degree
    EXPECT_NEAR(one.max_dihedral, one.min_dihedral, 1e-9);
    EXPECT_NEAR(one.min_radius_ratio, 1.0, 1e-12);
    EXPECT_NEAR(one.min_edge, h * std::sqrt(2.0), 1e-15);
    EXPECT_THAT(one.warnings, IsEmpty());
  }
}

TEST(Quality, OfTheCornerOfACube) {
  const MeshQuality q = measure_quality(one_tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}));
  EXPECT_NEAR(q.volume, 1.0 / 6.0, 1e-16);
  EXPECT_NEAR(q.max_dihedral, 90.0, 1e-12);
  EXPECT_NEAR(q.min_dihedral, std::acos(1.0 / std::sqrt(3.0)) * 180 / M_PI,
              1e-12);  // the slope's angle: 54.7356
  // r_in = 3 V / A = 0.5 / (3/2 + sqrt(3)/2), r_circum = sqrt(3)/2
  EXPECT_NEAR(q.min_radius_ratio, 3 * 0.5 / (1.5 + std::sqrt(3.0) / 2) / (std::sqrt(3.0) / 2), 1e-14);
  EXPECT_NEAR(q.mean_radius_ratio, q.min_radius_ratio, 1e-15);
}

TEST(Quality, OfTwoBoxes) {
  const MeshQuality q = measure_quality(read_mesh(data_file("two_boxes.v41.text.msh"), 0.1).mesh);
  EXPECT_EQ(q.nodes, 23);
  EXPECT_EQ(q.surface_nodes, 22);  // all but the centre of the common face
  EXPECT_EQ(q.tetrahedra, 48);
  EXPECT_EQ(q.surface_triangles, 40);  // four on each of ten squares
  EXPECT_EQ(q.components, 1);
  EXPECT_NEAR(q.volume, 2e-3, 1e-17);
  EXPECT_NEAR((q.upper - q.lower - Vec3(0.2, 0.1, 0.1)).norm(), 0.0, 1e-16);
}

TEST(Quality, WarnsOfSlivers) {
  // Opposite edges of a square, lifted by little: angle at the long edge about 2 h / (a / sqrt 2) with a =
  // 0.1.
  const double a = 0.1, h = 1e-5;
  TetMesh sliver = one_tetrahedron({0, 0, 0}, {a, 0, h}, {a, a, 0}, {0, a, h});
  if (measure_quality(sliver).volume < 0) std::swap(sliver.tetrahedra[0][2], sliver.tetrahedra[0][3]);
  EXPECT_THAT(measure_quality(sliver).warnings,
              ElementsAre(AllOf(HasSubstr("1 of 1 tetrahedra are slivers"), HasSubstr("below 1 degree"),
                                HasSubstr("tetrahedron 0 (nodes 11,"))));
}

TEST(Quality, WarnsOfUnlikelySizes) {
  for (const double side : {1e-4, 12.0, 1200.0})
    EXPECT_THAT(measure_quality(cube_mesh(1, side)).warnings, ElementsAre(HasSubstr("Was the unit right?")))
        << side;
  for (const double side : {1e-3, 0.05, 2.0})
    EXPECT_THAT(measure_quality(cube_mesh(1, side)).warnings, IsEmpty()) << side;
}

TEST(Quality, WarnsOfPieces) {
  TetMesh two = cube_mesh(1, 0.1);
  const auto nodes = static_cast<int>(two.nodes.size());
  for (const Vec3& x : cube_mesh(1, 0.1).nodes) two.nodes.push_back(x + Vec3(0.3, 0, 0));
  for (Tetrahedron t : cube_mesh(1, 0.1).tetrahedra) {
    for (int& node : t) node += nodes;
    two.tetrahedra.push_back(t);
  }
  for (int i = 9; i <= 16; ++i) two.node_tags.push_back(i);
  const MeshQuality q = measure_quality(two);
  EXPECT_EQ(q.components, 2);
  EXPECT_THAT(q.warnings, ElementsAre(AllOf(HasSubstr("2 pieces"), HasSubstr("8 nodes (one is node 9)"))));
}

TEST(Quality, OfFlatTetrahedraIsFinite) {
  const MeshQuality q = measure_quality(one_tetrahedron({0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  EXPECT_TRUE(std::isfinite(q.min_dihedral) && std::isfinite(q.min_radius_ratio));
  EXPECT_EQ(q.min_radius_ratio, 0.0);
}

}  // namespace
}  // namespace palpate::sim::test
