#include "sim/compile/overlap.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/sim/support/box_mesh.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A box of lower corner `at`, of so many cells.
Body box(const Vec3& at, const Vec3& size, int nx = 2, int ny = 2, int nz = 2) {
  TetMesh mesh = test::box_mesh(nx, ny, nz, size);
  for (Vec3& node : mesh.nodes) node += at;
  Body body;
  body.surface = std::make_shared<const Surface>(extract_surface(mesh));
  body.mesh = std::make_shared<const TetMesh>(std::move(mesh));
  return body;
}

const Body kCube = box(Vec3(0, 0, 0), Vec3(1, 1, 1));

TEST(OverlapAtRest, IsNothingForBodiesThatAreApartOrTouch) {
  EXPECT_EQ(overlap_at_rest(kCube, box(Vec3(0, 0, 1.1), Vec3(1, 1, 1))), 0.0);
  // face on face, edge on edge, corner on corner, flush and shifted; sums of heights are rounded
  for (const Vec3& at :
       {Vec3(0, 0, 1), Vec3(0.3, 0.21, 1), Vec3(1, 0, 1), Vec3(1, 1, 1), Vec3(-0.37, 0.4, -1)})
    EXPECT_LT(overlap_at_rest(kCube, box(at, Vec3(1, 1, 1))), 1e-15) << at.transpose();
}

TEST(OverlapAtRest, IsSeenWhicheverHasItsNodesInTheOther) {
  const Body spike =
      box(Vec3(0.4, 0.4, 0.9), Vec3(0.2, 0.2, 1), 1, 1, 1);  // none of the cube's nodes is in it
  EXPECT_NEAR(overlap_at_rest(kCube, spike), 0.1, 1e-12);
  EXPECT_NEAR(overlap_at_rest(spike, kCube), 0.1, 1e-12);
}

// Each crosses the other from side to side: edges go through faces, and no node of either lies in the other.
TEST(OverlapAtRest, IsSeenWhereEdgesCrossABody) {
  const Body along = box(Vec3(-2, 0, 0), Vec3(4, 1, 1), 1, 1, 1);
  for (const double sunk : {1e-6, 0.01, 0.3}) {
    const Body across = box(Vec3(-0.4, -2, 1 - sunk), Vec3(0.8, 5, 1), 1, 1, 1);
    EXPECT_NEAR(overlap_at_rest(along, across), sunk, 1e-9) << sunk;
    EXPECT_NEAR(overlap_at_rest(across, along), sunk, 1e-9) << sunk;
  }
}

TEST(OverlapAtRest, IsSeenOfBodiesInTheSamePlace) {
  EXPECT_GT(overlap_at_rest(kCube, kCube), 0.05);
}

TEST(RefuseOverlap, TakesWhatIsDeclaredAndNoMore) {
  const auto scene = test::write_two_boxes({.gap = -0.1e-3});
  const std::vector<Override> enough{{"contact.overlap", "0.1001 mm"}},
      little{{"contact.overlap", "0.09 mm"}};
  EXPECT_EQ(test::compile_scene(scene, enough).overlap, 0.1001e-3);
  EXPECT_THAT([&] { test::compile_scene(scene, little); },
              ThrowsMessage<std::invalid_argument>(AllOf(
                  HasSubstr("contact.overlap: found 0.09 mm, and upper and lower overlap at rest by 0.1 mm"),
                  HasSubstr("accepted: at least that"))));
  EXPECT_THAT(
      [&] { test::compile_scene(scene); },
      ThrowsMessage<std::invalid_argument>(AllOf(
          HasSubstr("bodies: upper and lower overlap at rest by 0.1 mm"), HasSubstr("contact.overlap"))));
}

}  // namespace
}  // namespace palpate::sim
