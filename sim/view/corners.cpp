#include "sim/view/corners.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "sim/view/rod.hpp"

namespace palpate::sim {
namespace {

constexpr float kReadFromALegend = 2.0F;  // in the place of an opacity: as the shaders take it
constexpr float kCosCrease = 0.766F;  // 40 degrees: finer than any cube's edge, coarser than a coarse sphere

struct Incidence {
  std::vector<int> begin;      // of each node, n + 1
  std::vector<int> triangles;  // around node i: [begin[i], begin[i + 1])
};

Incidence triangles_around_nodes(const std::vector<Triangle>& triangles, Eigen::Index nodes) {
  Incidence around{std::vector<int>(nodes + 1), std::vector<int>(3 * triangles.size())};
  for (const Triangle& triangle : triangles)
    for (const int node : triangle) ++around.begin[node + 1];
  std::partial_sum(around.begin.begin(), around.begin.end(), around.begin.begin());
  std::vector<int> next = around.begin;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (const int node : triangles[t]) around.triangles[next[node]++] = static_cast<int>(t);
  return around;
}

/// Rotation and shift from the world to the camera.
struct View {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 eye = Vec3::Zero();
};

View view_of(const Camera& camera) {
  const Vec3 back = camera.eye - camera.target;
  const Vec3 right = camera.up.cross(back);
  if (!(right.norm() > 1e-9 * camera.up.norm() * back.norm()))
    throw std::invalid_argument("camera: the eye must lie apart from the target, and not along `up` from it");
  View view;
  view.eye = camera.eye;
  view.rotation.row(0) = right.normalized();
  view.rotation.row(2) = back.normalized();
  view.rotation.row(1) = Vec3(view.rotation.row(2)).cross(Vec3(view.rotation.row(0)));
  return view;
}

Eigen::Vector4f rgba(const Colour& colour, float opacity) {
  return {colour.red, colour.green, colour.blue, opacity};
}

void add_body(const DrawnBody& body, const View& view, std::vector<Corner>& to) {
  // The shift is in double: the eye may be far from a small body.
  const Eigen::Matrix3Xf seen =
      (view.rotation * (body.positions.cast<double>().colwise() - view.eye)).cast<float>();
  const Eigen::Matrix3Xf normals = corner_normals(seen, body.triangles);
  Eigen::Index corner = 0;
  for (const Triangle& triangle : body.triangles) {
    for (int k = 0; k < 3; ++k, ++corner) {
      Eigen::Vector4f colour = rgba(body.colour, body.opacity);
      if (body.corner_colours.size() > 0) colour << body.corner_colours.col(corner), kReadFromALegend;
      to.push_back({seen.col(triangle[k]), normals.col(corner), colour, Eigen::Vector3f::Unit(k)});
    }
  }
}

void add_probe(const DrawnProbe& probe, const View& view, std::vector<Corner>& to) {
  const Vec3 axis = probe.shaft.normalized();
  const Vec3 end = probe.touch - probe.radius * probe.direction;
  const Eigen::Matrix3d turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), axis).toRotationMatrix();
  for (const RodPoint& point : rod(probe.radius, probe.length)) {
    to.push_back({(view.rotation * (turn * point.position + end - view.eye)).cast<float>(),
                  (view.rotation * turn * point.normal).cast<float>(), rgba(probe.colour, 1.0F),
                  Eigen::Vector3f::Ones()});
  }
}

/// The painter's order. Triangles of one distance are ordered by where they lie, so that the order in which
/// they were given shows nowhere.
void sort_far_to_near(std::vector<Corner>& corners) {
  using Key = std::array<float, 4>;
  std::vector<std::pair<Key, std::size_t>> order;
  order.reserve(corners.size() / 3);
  for (std::size_t c = 0; c < corners.size(); c += 3) {
    const Eigen::Vector3f sum = corners[c].position + corners[c + 1].position + corners[c + 2].position;
    order.push_back({{-sum.squaredNorm(), sum.x(), sum.y(), sum.z()}, c});
  }
  std::ranges::sort(order);
  std::vector<Corner> sorted;
  sorted.reserve(corners.size());
  for (const auto& [key, c] : order) sorted.insert(sorted.end(), &corners[c], &corners[c] + 3);
  corners = std::move(sorted);
}

}  // namespace

Eigen::Matrix3Xf corner_normals(const Eigen::Matrix3Xf& positions, const std::vector<Triangle>& triangles) {
  const auto count = static_cast<Eigen::Index>(triangles.size());
  Eigen::Matrix3Xf area(3, count), unit(3, count);  // twice the area along the normal
  for (Eigen::Index t = 0; t < count; ++t) {
    const Triangle& triangle = triangles[t];
    const Eigen::Vector3f p = positions.col(triangle[0]);
    area.col(t) = (positions.col(triangle[1]) - p).cross(positions.col(triangle[2]) - p);
    unit.col(t) = area.col(t).stableNormalized();
  }
  const Incidence around = triangles_around_nodes(triangles, positions.cols());
  Eigen::Matrix3Xf normals(3, 3 * count);
  for (Eigen::Index t = 0; t < count; ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t node = triangles[t][k];
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      for (int i = around.begin[node]; i < around.begin[node + 1]; ++i) {
        const int other = around.triangles[i];
        if (other == t || unit.col(t).dot(unit.col(other)) > kCosCrease) sum += area.col(other);
      }
      normals.col(3 * t + static_cast<Eigen::Index>(k)) = sum.stableNormalized();
    }
  }
  return normals;
}

Corners corners_of(const Picture& picture) {
  const View view = view_of(picture.camera);
  Corners corners;
  for (const DrawnBody& body : picture.bodies)
    if (body.opacity > 0) add_body(body, view, body.opacity < 1 ? corners.translucent : corners.opaque);
  for (const DrawnProbe& probe : picture.probes) add_probe(probe, view, corners.opaque);
  sort_far_to_near(corners.translucent);
  return corners;
}

}  // namespace palpate::sim
