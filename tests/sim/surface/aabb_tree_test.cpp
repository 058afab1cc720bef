#include "sim/surface/aabb_tree.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <random>

namespace palpate::sim {
namespace {

/// A wavy sheet of 2 n^2 triangles.
struct Sheet {
  std::vector<Triangle> triangles;
  Eigen::Matrix3Xd positions;
};
Sheet wavy_sheet(int n, std::mt19937_64& random) {
  Sheet sheet;
  std::normal_distribution<double> bump(0.0, 0.3);
  sheet.positions.resize(3, (n + 1) * (n + 1));
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) sheet.positions.col(i * (n + 1) + j) = Vec3(i, j, bump(random));
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j, b = a + n + 1, c = b + 1, d = a + 1;
      sheet.triangles.push_back({a, b, c});
      sheet.triangles.push_back({a, c, d});
    }
  return sheet;
}

double brute_force(const Sheet& sheet, const Vec3& place) {
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& t : sheet.triangles)
    least = std::min(least, (nearest_on_triangle(place, sheet.positions.col(t[0]), sheet.positions.col(t[1]),
                                                 sheet.positions.col(t[2]))
                                 .point -
                             place)
                                .norm());
  return least;
}

RC_GTEST_PROP(AabbTree, FindsWhatLookingAtEveryPolygonFinds, (unsigned seed)) {
  std::mt19937_64 random(seed);
  const Sheet sheet = wavy_sheet(6, random);
  const AabbTree tree = build_tree(sheet.triangles, sheet.positions);
  std::uniform_real_distribution<double> anywhere(-2.0, 8.0);
  for (int i = 0; i < 20; ++i) {
    const Vec3 place(anywhere(random), anywhere(random), anywhere(random) / 4);
    const auto found = find_nearest(tree, sheet.triangles, sheet.positions, place, 1e9);
    RC_ASSERT(std::abs(std::sqrt(found.squared_distance) - brute_force(sheet, place)) < 1e-12);
  }
}

// The nearest point of a convex set is the one whose offset makes no acute angle with the way to any other
// point of it.
RC_GTEST_PROP(NearestOnTriangle, NoCornerLiesOnTheNearSide, (unsigned seed)) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
  const auto point = [&] { return Vec3(anywhere(random), anywhere(random), anywhere(random)); };
  const Vec3 a = point(), b = point(), c = point(), place = 3.0 * point();
  const Vec3 nearest = nearest_on_triangle(place, a, b, c).point;
  for (const Vec3& corner : {a, b, c}) RC_ASSERT((place - nearest).dot(corner - nearest) < 1e-9);
}

// Not the leaf's motion: a polygon that has moved far makes no other one nearer.
RC_GTEST_PROP(AabbTree, FindsTheNearestOfThoseThatMotionBringsNear, (unsigned seed)) {
  std::mt19937_64 random(seed);
  const Sheet sheet = wavy_sheet(6, random);
  const AabbTree tree = build_tree(sheet.triangles, sheet.positions);
  std::uniform_real_distribution<double> anywhere(-2.0, 8.0), some(0.0, 1.5);
  std::vector<double> moved(sheet.triangles.size());
  for (double& polygon : moved) polygon = some(random);
  for (int i = 0; i < 20; ++i) {
    const Vec3 place(anywhere(random), anywhere(random), anywhere(random) / 4);
    const double within = some(random);
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int p = 0; p < std::ssize(sheet.triangles); ++p) {
      const double distance = brute_force({{sheet.triangles[p]}, sheet.positions}, place);
      if (distance > within + moved[p] || distance >= least) continue;
      least = distance;
      nearest = p;
    }
    const auto found = find_nearest(tree, sheet.triangles, sheet.positions, place, within, moved);
    RC_ASSERT((found.polygon < 0) == (nearest < 0));
    if (nearest >= 0) RC_ASSERT(std::abs(std::sqrt(found.squared_distance) - least) < 1e-12);
  }
}

TEST(AabbTree, LooksNoFurtherThanTheMotion) {
  std::mt19937_64 random(1);
  const Sheet sheet = wavy_sheet(4, random);
  const AabbTree tree = build_tree(sheet.triangles, sheet.positions);
  const Vec3 place(2, 2, 3);
  const double away = brute_force(sheet, place);
  EXPECT_EQ(find_nearest(tree, sheet.triangles, sheet.positions, place, 0.99 * away).polygon, -1);
  EXPECT_GE(find_nearest(tree, sheet.triangles, sheet.positions, place, 1.01 * away).polygon, 0);
  const std::vector<double> moved(sheet.triangles.size(), 0.02 * away);  // the polygons' own counts as well
  EXPECT_GE(find_nearest(tree, sheet.triangles, sheet.positions, place, 0.99 * away, moved).polygon, 0);
}

}  // namespace
}  // namespace palpate::sim
