#include "sim/pairing/placement.hpp"

#include <algorithm>

#include "sim/pairing/outward.hpp"

namespace palpate::sim {
namespace {

PlacedBody at_rest(const Body& body) {
  PlacedBody placed{.positions = body.rest, .motion = std::vector<double>(body.rest.cols(), 0.0)};
  const auto& triangles = body.polygons.triangles;
  const auto polygons = static_cast<Eigen::Index>(triangles.size());
  placed.rest_normals.resize(3, polygons);
  for (Eigen::Index i = 0; i < polygons; ++i)
    placed.rest_normals.col(i) = area_vector(triangles[i], body.rest).normalized();
  placed.normals = placed.rest_normals;
  placed.polygon_motion.assign(triangles.size(), 0.0);
  placed.made.assign(triangles.size(), 0);
  return placed;
}

void put_back(const Body& body, PlacedBody& placed) {
  placed.positions = body.rest;
  std::ranges::fill(placed.motion, 0.0);
  std::ranges::fill(placed.polygon_motion, 0.0);
  placed.farthest = 0.0;
}

void move(const Body& body, const Eigen::VectorXd& displacement, PlacedBody& placed) {
  const Eigen::Map<const Eigen::Matrix3Xd> by(displacement.data(), 3, body.rest.cols());
  placed.positions = body.rest + by;
  for (std::size_t i = 0; i < placed.motion.size(); ++i)
    placed.motion[i] = by.col(static_cast<Eigen::Index>(i)).norm();
  double farthest = 0.0;
  for (std::size_t i = 0; i < placed.polygon_motion.size(); ++i) {
    const auto [a, b, c] = body.polygons.triangles[i];
    const double of_polygon = std::max(std::max(placed.motion[a], placed.motion[b]), placed.motion[c]);
    placed.polygon_motion[i] = of_polygon;
    farthest = std::max(farthest, of_polygon);
  }
  placed.farthest = farthest;
}

}  // namespace

Placement rest_placement(const Model& model) {
  Placement placement{.sides = meeting_sides(model)};
  std::size_t most = 0;
  for (const Body& body : model.bodies) {
    placement.bodies.push_back(at_rest(body));
    most = std::max(most, body.polygons.triangles.size());
  }
  placement.passed.reserve(most);
  return placement;
}

void place(const Model& model, const FreeMotion& motion, Placement& placement) {
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const Body& body = model.bodies[i];
    PlacedBody& placed = placement[i];
    const bool was_moved = placed.moved;
    placed.moved = motion[i].moved;
    ++placed.count;
    if (placed.moved)
      move(body, motion[i].displacement, placed);
    else if (was_moved)  // whatever the cycle before has left
      put_back(body, placed);
  }
}

Vec3 polygon_normal(const Body& body, PlacedBody& placed, int polygon) {
  if (!placed.moved) return placed.rest_normals.col(polygon);
  if (placed.made[polygon] != placed.count) {
    placed.normals.col(polygon) =
        area_vector(body.polygons.triangles[polygon], placed.positions).normalized();
    placed.made[polygon] = placed.count;
  }
  return placed.normals.col(polygon);
}

}  // namespace palpate::sim
