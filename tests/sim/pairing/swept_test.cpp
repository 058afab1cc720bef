#include "sim/pairing/swept.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/sim/support/box_mesh.hpp"
#include "tests/sim/support/loose_body.hpp"

namespace palpate::sim {
namespace {

const std::array<Vec3, 3> kFlat{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};  // normal +z

TEST(Swept, GoesInAgainstTheNormalAndOutAlongIt) {
  const SweptTriangle still{kFlat, kFlat};
  EXPECT_EQ(times_entered({0.2, 0.2, 1}, {0.2, 0.2, -1}, still), 1);
  EXPECT_EQ(times_entered({0.2, 0.2, -1}, {0.2, 0.2, 1}, still), -1);
  EXPECT_EQ(times_entered({0.2, 0.2, 1}, {0.2, 0.2, 0.1}, still), 0);  // not as far
  EXPECT_EQ(times_entered({0.7, 0.7, 1}, {0.7, 0.7, -1}, still), 0);   // beside it
  EXPECT_EQ(times_entered({0.2, 0.2, 0}, {0.2, 0.2, -1}, still), 1);   // it rests on it
}

TEST(Swept, EdgesAndCornersBelongToIt) {
  const SweptTriangle still{kFlat, kFlat};
  for (const Vec3& on : {Vec3(0.5, 0, 0), Vec3(0, 0.5, 0), Vec3(0.5, 0.5, 0), Vec3(0, 0, 0), Vec3(1, 0, 0)})
    EXPECT_EQ(times_entered(on + Vec3(0.3, -0.2, 1), on - Vec3(0.3, -0.2, 1), still), 1) << on.transpose();
}

TEST(Swept, ATriangleThatComesToARestingPlaceGoesThroughItAsWell) {
  std::array<Vec3, 3> raised = kFlat;
  for (Vec3& corner : raised) corner.z() += 1.0;
  EXPECT_EQ(times_entered({0.2, 0.2, 0.5}, {0.2, 0.2, 0.5}, {kFlat, raised}), 1);
  EXPECT_EQ(times_entered({0.2, 0.2, 1.5}, {0.2, 0.2, 1.5}, {kFlat, raised}), 0);
  EXPECT_EQ(times_entered({0.2, 0.2, 0.5}, {0.2, 0.2, 1.5}, {kFlat, raised}), 0);  // they go together
}

/// How often a closed surface winds round a place: the sum of the polygons' solid angles [VanOosterom1983] over 4 pi.
double winding(const Body& body, const Eigen::Matrix3Xd& positions, const Vec3& place) {
  double angle = 0.0;
  for (const auto& [a, b, c] : body.polygons.triangles) {
    const Vec3 p = positions.col(a) - place, q = positions.col(b) - place, r = positions.col(c) - place;
    angle += 2.0 * std::atan2(p.dot(q.cross(r)), p.norm() * q.norm() * r.norm() + p.dot(q) * r.norm() +
                                                     q.dot(r) * p.norm() + r.dot(p) * q.norm());
  }
  return angle / (4.0 * std::numbers::pi);
}

// What goes in and out of the polygons of a closed surface, however both move, is what the surface winds round the
// place more often at the end than at the beginning.
RC_GTEST_PROP(Swept, CrossingsOfAClosedSurfaceAddUpToItsWinding, (unsigned seed)) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> some(0.0, 0.4);
  const auto shift = [&] { return Vec3(some(random), some(random), some(random)); };
  const Body box = test::loose_body(test::box_mesh(2, 2, 2, Vec3(1, 1, 1)), Vec3::Zero());
  Eigen::Matrix3Xd now = box.rest;
  for (Eigen::Index i = 0; i < now.cols(); ++i) now.col(i) += shift();
  for (int k = 0; k < 20; ++k) {
    const Vec3 from = Vec3(0.5, 0.5, 0.5) + 2.0 * shift(), to = from + 2.0 * shift();
    int entered = 0;
    for (const auto& [a, b, c] : box.polygons.triangles)
      entered += times_entered(
          from, to,
          {{box.rest.col(a), box.rest.col(b), box.rest.col(c)}, {now.col(a), now.col(b), now.col(c)}});
    RC_ASSERT(std::abs(winding(box, now, to) - winding(box, box.rest, from) - entered) < 1e-6);
  }
}

}  // namespace
}  // namespace palpate::sim
