#include "sim/view/corners.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>

#include "sim/mesh/surface.hpp"
#include "sim/view/rod.hpp"
#include "tests/sim/support/ball.hpp"
#include "tests/sim/support/box_mesh.hpp"

namespace palpate::sim {
namespace {

TEST(CornerNormals, OfABallPointFromItsCentre) {
  const DrawnBody body = test::ball({0, 0, 0}, 2.0F, 3);
  const Eigen::Matrix3Xf normals = corner_normals(body.positions, body.triangles);
  Eigen::Index corner = 0;
  for (const Triangle& triangle : body.triangles)
    for (const int node : triangle) {
      // 0.02: the means of five or six flat faces, 7 degrees apart
      EXPECT_LT((normals.col(corner++) - body.positions.col(node) / 2.0F).norm(), 0.02F);
    }
}

TEST(CornerNormals, KeepTheEdgesOfABox) {
  const TetMesh box = test::box_mesh(2, 2, 2, Vec3(1, 1, 1));
  const std::vector<Triangle> triangles = extract_surface(box).triangles;
  Eigen::Matrix3Xf positions(3, static_cast<Eigen::Index>(box.nodes.size()));
  for (Eigen::Index i = 0; i < positions.cols(); ++i) positions.col(i) = box.nodes[i].cast<float>();
  const Eigen::Matrix3Xf normals = corner_normals(positions, triangles);
  for (Eigen::Index t = 0; t < static_cast<Eigen::Index>(triangles.size()); ++t) {
    const Triangle& triangle = triangles[t];
    const Eigen::Vector3f p = positions.col(triangle[0]);
    const Eigen::Vector3f face =
        (positions.col(triangle[1]) - p).cross(positions.col(triangle[2]) - p).normalized();
    for (Eigen::Index k = 0; k < 3; ++k) EXPECT_LT((normals.col(3 * t + k) - face).norm(), 1e-6F);
  }
}

TEST(Rod, LiesOneRadiusFromItsAxisAndFacesOutwards) {
  const double radius = 0.3, length = 1.1;
  const std::vector<RodPoint> points = rod(radius, length);
  ASSERT_EQ(points.size() % 3, 0U);
  double area = 0.0;
  for (std::size_t i = 0; i < points.size(); i += 3) {
    for (std::size_t k = i; k < i + 3; ++k) {
      const Vec3& p = points[k].position;
      const Vec3 on_axis(0, 0, std::clamp(p.z(), 0.0, length));
      EXPECT_NEAR((p - on_axis).norm(), radius, 1e-12);
      EXPECT_LT(((p - on_axis) / radius - points[k].normal).norm(), 1e-12);
    }
    const Vec3 face =
        (points[i + 1].position - points[i].position).cross(points[i + 2].position - points[i].position);
    area += face.norm() / 2;
    // A triangle at a pole has two corners in one place.
    if (face.norm() > 1e-12) {
      EXPECT_GT(face.dot(points[i].normal + points[i + 1].normal + points[i + 2].normal), 0);
    }
  }
  // A closed rod: 4 pi r^2 + 2 pi r l, a little less for its facets.
  EXPECT_NEAR(area, 4 * M_PI * radius * radius + 2 * M_PI * radius * length, 0.01 * area);
}

}  // namespace
}  // namespace palpate::sim
