#include "sim/pairing/find_pairs.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "sim/pairing/swept.hpp"
#include "tests/sim/support/box_mesh.hpp"
#include "tests/sim/support/loose_body.hpp"

namespace palpate::sim {
namespace {

using test::loose_body;

Pairs pairs_at(const Model& model, const FreeMotion& motion) {
  Placement placement = rest_placement(model);
  place(model, motion, placement);
  Pairs pairs;
  find_pairs(model, motion, placement, pairs);
  return pairs;
}

/// Where the nodes of a body are.
Eigen::Matrix3Xd places(const Body& body, const BodyMotion& motion) {
  return body.rest + Eigen::Map<const Eigen::Matrix3Xd>(motion.displacement.data(), 3, body.rest.cols());
}

Vec3 normal_of(const Eigen::Matrix3Xd& at, const Triangle& t) {
  const Vec3 a = at.col(t[0]);
  return (Vec3(at.col(t[1])) - a).cross(Vec3(at.col(t[2])) - a).normalized();
}

bool faces(const Body& nodes, int node, const Vec3& normal) {
  return std::ranges::any_of(nodes.polygons.triangles, [&](const Triangle& own) {
    return std::ranges::find(own, node) != own.end() && normal_of(nodes.rest, own).dot(normal) < -1e-9;
  });
}

/// The definition of find_pairs(), looking at every polygon: the polygon of each node that
/// collides.
std::map<int, int> by_definition(const Body& a, const BodyMotion& motion_a, const Body& b,
                                 const BodyMotion& motion_b) {
  const Eigen::Matrix3Xd now_a = places(a, motion_a), now_b = places(b, motion_b);
  std::map<int, int> found;
  for (int node = 0; node < a.rest.cols(); ++node) {
    const Vec3 rest = a.rest.col(node), now = now_a.col(node);
    struct Behind {
      int polygon = 0;
      double distance = 0.0, depth = 0.0;
    };
    std::vector<Behind> behind;
    double least = std::numeric_limits<double>::infinity();
    bool entered = false;
    for (int s = 0; s < std::ssize(b.polygons.triangles); ++s) {
      const Triangle& t = b.polygons.triangles[s];
      const auto distance = [&](const Eigen::Matrix3Xd& at, const Vec3& from) {
        return (nearest_on_triangle(from, at.col(t[0]), at.col(t[1]), at.col(t[2])).point - from).norm();
      };
      double come = (now - rest).norm(), polygon = 0.0;
      for (const int corner : t) polygon = std::max(polygon, (now_b.col(corner) - b.rest.col(corner)).norm());
      const Vec3 at_rest = normal_of(b.rest, t);
      if ((rest - b.rest.col(t[0])).dot(at_rest) < 0.0 || !faces(a, node, at_rest)) continue;
      if (distance(b.rest, rest) > come + polygon) continue;
      entered = entered || times_entered(rest, now,
                                         {{b.rest.col(t[0]), b.rest.col(t[1]), b.rest.col(t[2])},
                                          {now_b.col(t[0]), now_b.col(t[1]), now_b.col(t[2])}}) > 0;
      const double depth = (now_b.col(t[0]) - now).dot(normal_of(now_b, t));
      if (depth <= 0.0) continue;
      behind.push_back({s, distance(now_b, now), depth});
      least = std::min(least, behind.back().distance);
    }
    // On a common edge the distances are alike but for rounding.
    std::erase_if(behind, [&](const Behind& polygon) { return polygon.distance > least + 1e-9; });
    if (!behind.empty() && entered)
      found[node] = std::ranges::max_element(behind, {}, &Behind::depth)->polygon;
  }
  return found;
}

/// Two boxes one above the other, turned and shaken a little so that nothing is as near as anything else, and a push
/// of the upper one into the lower one.
struct Pressed {
  Model model{};
  FreeMotion motion{};
};
Pressed pressed(unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> some(-1.0, 1.0);
  const auto shift = [&](double by) -> Vec3 { return by * Vec3(some(random), some(random), some(random)); };
  const auto shaken = [&](Body body) {
    Eigen::Matrix3Xd nodes = body.rest;
    for (Eigen::Index i = 0; i < nodes.cols(); ++i) nodes.col(i) += shift(0.04);
    return loose_body(nodes, body.polygons.triangles);
  };
  Pressed all{.model = test::loose_pair(
                  shaken(loose_body(test::box_mesh(4, 4, 1, Vec3(2, 2, 0.5)), Vec3(0.3, 0.2, 1.2))),
                  shaken(loose_body(test::box_mesh(5, 5, 2, Vec3(2.4, 2.4, 1)), Vec3::Zero())))};
  const double depth = 0.6 + 0.5 * some(random);
  const Vec3 middle = Vec3(1.2, 1.2, 1.2) + shift(0.4);
  const auto push = [&](const Vec3& rest) {
    return Vec3(rest + depth * std::exp(-(rest - middle).squaredNorm()) * Vec3(0.2, 0.1, -1) + shift(0.02));
  };
  const auto yield = [&](const Vec3& rest) { return Vec3(rest + shift(0.05)); };
  all.motion = {test::motion_to(all.model.bodies[0], push),
                seed % 2 ? test::motion_to(all.model.bodies[1], yield) : test::at_rest(all.model.bodies[1])};
  return all;
}

// Lists, bounds and the order of looking change nothing.
RC_GTEST_PROP(FindPairs, FindsWhatLookingAtEveryPolygonFinds, (unsigned seed)) {
  const auto [model, motion] = pressed(seed);
  std::array<std::map<int, int>, 2> found;
  for (const CollidingPair& pair : pairs_at(model, motion)) found[pair.node_body][pair.node] = pair.polygon;
  RC_ASSERT(found[0] == by_definition(model.bodies[0], motion[0], model.bodies[1], motion[1]));
  RC_ASSERT(found[1] == by_definition(model.bodies[1], motion[1], model.bodies[0], motion[0]));
  RC_TAG(found[0].empty() && found[1].empty() ? "apart" : "colliding");
}

// A pose is all that counts: what was placed before leaves nothing behind.
RC_GTEST_PROP(FindPairs, TellsTheSameAfterAnyOtherPose, (unsigned seed)) {
  const auto [model, motion] = pressed(seed);
  FreeMotion other = motion;
  for (BodyMotion& body : other) body = {.displacement = 1.5 * body.displacement, .moved = true};
  Placement placement = rest_placement(model);
  Pairs pairs;
  for (const FreeMotion& pose : {other, motion}) {
    place(model, pose, placement);
    find_pairs(model, pose, placement, pairs);
  }
  const Pairs fresh = pairs_at(model, motion);
  RC_ASSERT(pairs.size() == fresh.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    RC_ASSERT(pairs[i].node == fresh[i].node && pairs[i].polygon == fresh[i].polygon);
    RC_ASSERT(pairs[i].depth == fresh[i].depth);
  }
}

Body mirrored(const Body& body) {
  Eigen::Matrix3Xd nodes = body.rest;
  nodes.row(0) *= -1.0;
  std::vector<Triangle> triangles = body.polygons.triangles;
  for (auto& [a, b, c] : triangles) std::swap(b, c);
  return loose_body(nodes, triangles);
}

BodyMotion mirrored(BodyMotion motion) {
  for (Eigen::Index i = 0; i < motion.displacement.size(); i += 3) motion.displacement[i] *= -1.0;
  return motion;
}

// Boxes whose nodes face nodes and edges: all pairs are ties.
Pressed aligned(double depth) {
  Pressed all{.model = test::loose_pair(loose_body(test::box_mesh(4, 4, 1, Vec3(2, 2, 0.5)), Vec3(0, 0, 1)),
                                        loose_body(test::box_mesh(4, 4, 2, Vec3(2, 2, 1)), Vec3::Zero()))};
  all.motion = {test::motion_to(all.model.bodies[0],
                                [&](const Vec3& rest) { return Vec3(rest - depth * Vec3::UnitZ()); }),
                test::at_rest(all.model.bodies[1])};
  return all;
}

TEST(FindPairs, AMirroredSceneHasTheSamePairsMirrored) {
  for (const double depth : {1e-3, 0.1, 0.3, 0.7}) {
    const auto [model, motion] = aligned(depth);
    const Pairs pairs = pairs_at(model, motion);
    const Pairs other = pairs_at(test::loose_pair(mirrored(model.bodies[0]), mirrored(model.bodies[1])),
                                 {mirrored(motion[0]), mirrored(motion[1])});
    ASSERT_EQ(pairs.size(), other.size());
    EXPECT_GE(pairs.size(), 50U);  // the 25 nodes of each of the two faces
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      EXPECT_EQ(pairs[i].node, other[i].node);
      EXPECT_EQ(pairs[i].polygon, other[i].polygon);
      EXPECT_NEAR(pairs[i].depth, other[i].depth, 1e-14);
      EXPECT_LT((pairs[i].normal.cwiseProduct(Vec3(-1, 1, 1)) - other[i].normal).norm(), 1e-14);
    }
  }
}

/// A groove along y whose flanks rise by these slopes to the left (x < 0) and to the right, its deepest line at z = 0,
/// and a tip that comes down on it. The flank that is named first has the lower numbers.
Model groove(double left, double right, bool left_first, double x) {
  Eigen::Matrix3Xd nodes(3, 6);
  nodes << -1, -1, 0, 0, 1, 1,  //
      -1, 1, -1, 1, -1, 1,      //
      left, left, 0, 0, right, right;
  std::vector<Triangle> flanks{{0, 2, 3}, {0, 3, 1}, {2, 4, 5}, {2, 5, 3}};
  if (!left_first) std::ranges::rotate(flanks, flanks.begin() + 2);
  Eigen::Matrix3Xd tip(3, 4);
  tip << x, x - 0.1, x + 0.1, x,  //
      0.1, 0, 0, 0.2,             //
      0.5, 2, 2, 2;
  return test::loose_pair(loose_body(tip, {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}}), loose_body(nodes, flanks));
}

/// The polygon that the tip has passed 0.6 further down.
const CollidingPair tip_in(const Model& model) {
  const FreeMotion motion{
      test::motion_to(model.bodies[0], [](const Vec3& rest) { return Vec3(rest - Vec3(0, 0, 0.6)); }),
      test::at_rest(model.bodies[1])};
  for (const CollidingPair& pair : pairs_at(model, motion))
    if (pair.node_body == 0 && pair.node == 0) return pair;
  return {.polygon = -1};
}

// Below the deepest line of a groove the line is the nearest place of both flanks. The flank that the tip is deeper
// behind gets it, whichever has the lower number: the flatter one.
TEST(FindPairs, OnAConcaveEdgeTheDeeperFlankHasTheNode) {
  for (const bool left_first : {true, false})
    for (const double x : {0.0, 1e-12, -1e-12}) {
      const CollidingPair flatter = tip_in(groove(0.5, 2.0, left_first, x));
      ASSERT_GE(flatter.polygon, 0) << x;
      EXPECT_NEAR(flatter.depth, 0.1 / std::hypot(1.0, 0.5), 1e-11);
      EXPECT_GT(flatter.normal.x(), 0.0);  // the left flank looks to the right
    }
}

TEST(FindPairs, OfFlanksThatAreAlikeTheLowerNumberHasIt) {
  EXPECT_GT(tip_in(groove(1.0, 1.0, true, 0.0)).normal.x(), 0.0);
  EXPECT_LT(tip_in(groove(1.0, 1.0, false, 0.0)).normal.x(), 0.0);
}

// In front of the steep flank's plane and behind the flat one's: no tie may drop it.
TEST(FindPairs, ANodeBehindOneFlankOnlyBelongsToIt) {
  for (const bool left_first : {true, false}) {
    const CollidingPair pair = tip_in(groove(0.1, 3.0, left_first, -0.2));
    ASSERT_GE(pair.polygon, 0);
    EXPECT_GT(pair.normal.x(), 0.0);
  }
}

}  // namespace
}  // namespace palpate::sim
