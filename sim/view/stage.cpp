#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/surface/ray.hpp"
#include "sim/view/picture_of.hpp"

namespace palpate::sim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Bounds {
  Vec3 lower = Vec3::Constant(kInfinity), upper = Vec3::Constant(-kInfinity);  // [m]
  void add(const Vec3& p) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  double diagonal() const { return (upper - lower).norm(); }
};

Bounds bounds_of(const Model& model) {
  Bounds bounds;
  for (const Body& body : model.bodies)
    for (const Vec3& node : body.mesh->nodes) bounds.add(node);
  return bounds;
}

/// How far a point can go from p before it meets a body at rest [m].
double room(const Model& model, const Vec3& p, const Vec3& along) {
  double nearest = kInfinity;
  for (const Body& body : model.bodies) {
    const auto at = [&](int node) -> const Vec3& { return body.mesh->nodes[node]; };
    for (const Triangle& t : body.surface->triangles)
      nearest = std::min(nearest, distance_to_triangle(p, along, at(t[0]), at(t[1]), at(t[2])));
  }
  return nearest;
}

/// Two unit vectors that are perpendicular to n and to each other.
std::array<Vec3, 2> across(const Vec3& n) {
  const Vec3 first = n.unitOrthogonal();
  return {first, n.cross(first)};
}

/// How far a rod can go: the least room of its axis and of four lines on its skin.
double room_of_rod(const Model& model, const Vec3& end, const Vec3& along, double radius, double enough) {
  double least = std::min(enough, room(model, end, along));
  for (const Vec3& side : across(along)) {
    for (const double sign : {-1.0, 1.0}) {
      if (least < enough) return least;
      least = std::min(least, room(model, end + sign * radius * side, along));
    }
  }
  return least;
}

/// Directions in which a hand may be: straight back first, then all around. Earlier ones win among equals,
/// and the order does not come from the mesh: coarse and fine meshes of one body are shown from one side.
std::vector<Vec3> possible_shafts(const Probe& probe) {
  const Vec3 first = Vec3(-0.4, -0.8, 0.45).normalized();  // an end of a tube that a picture shows well
  const auto [right, up] = across(first);
  std::vector<Vec3> shafts = {-probe.direction};
  constexpr int kDirections = 800;
  const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < kDirections; ++i) {
    const double along = 1.0 - (2.0 * i + 1.0) / kDirections, r = std::sqrt(1.0 - along * along);
    shafts.push_back(r * std::cos(golden_angle * i) * right + r * std::sin(golden_angle * i) * up +
                     along * first);
  }
  return shafts;
}

double drawn_radius(const Probe& probe, const Body& body, double diagonal) {
  if (probe.nodes.size() == 1) return 0.022 * diagonal;  // a point has no size: as large as can be seen well
  if (probe.tip) return probe.tip->radius;
  double radius = 0.0;
  for (const int node : probe.nodes) radius = std::max(radius, (body.rest.col(node) - probe.at).norm());
  return radius;
}

/// Straight back where that is free. Else the middle of the opening through which the rod can leave: the mean
/// of the free directions near the first one found. Else where there is most room.
/// @return how far the rod can go that way, at most `enough` [m]
double choose_shaft(const Model& model, const Probe& probe, const Vec3& end, double enough,
                    ProbeShape& shape) {
  double best = 0.0;
  Vec3 mean = Vec3::Zero();
  for (const Vec3& shaft : possible_shafts(probe)) {
    if (shaft.dot(probe.direction) > 0.1) continue;  // the hand does not reach through what it presses
    const double free = room_of_rod(model, end, shaft, shape.radius, enough);
    if (free > best) shape.shaft = shaft;
    best = std::max(best, free);
    if (best == enough && shape.shaft == -probe.direction) return best;
    if (free == enough && shaft.dot(shape.shaft) > 0.5) mean += shaft;
  }
  if (best == enough && room_of_rod(model, end, mean.normalized(), shape.radius, enough) == enough)
    shape.shaft = mean.normalized();
  return best;
}

ProbeShape shape_of(const Model& model, const Probe& probe, const Bounds& bounds) {
  if (probe.region) return {.shaft = -probe.direction, .radius = 0.0, .length = 0.0};
  const double diagonal = bounds.diagonal(), skin = 1e-3 * diagonal;
  const double behind = room(model, probe.at - skin * probe.direction, -probe.direction);
  ProbeShape shape;
  shape.radius = std::min(drawn_radius(probe, model.bodies[probe.body], diagonal), 0.45 * behind);
  const Vec3 end = probe.at - (shape.radius + skin) * probe.direction;
  const double free = choose_shaft(model, probe, end, diagonal, shape);
  double leaves_bounds = kInfinity;
  for (int k = 0; k < 3; ++k) {
    const double face = shape.shaft[k] > 0 ? bounds.upper[k] : bounds.lower[k];
    if (shape.shaft[k] != 0.0) leaves_bounds = std::min(leaves_bounds, (face - end[k]) / shape.shaft[k]);
  }
  shape.length = std::min(free, std::max(0.0, leaves_bounds) + 0.18 * diagonal);
  return shape;
}

/// From the target towards the eye. Across the press, so that its depth is seen in full, then turned towards
/// the hand and upwards.
Vec3 looks_from(const Model& model, const std::vector<ProbeShape>& probes) {
  const Vec3 up = Vec3::UnitZ();
  if (probes.empty()) return Vec3(0.45, -0.75, 0.45);
  const Vec3 direction = model.probes.front().direction, shaft = probes.front().shaft;
  Vec3 side = direction.cross(shaft);
  if (side.norm() < 0.2) side = direction.cross(up);
  if (side.norm() < 0.2) side = direction.cross(Vec3::UnitX());
  side.normalize();
  if (side.dot(Vec3(0.3, -1.0, 0.1)) < 0) side = -side;
  Vec3 hand = shaft - shaft.dot(direction) * direction;
  hand = hand.norm() < 0.2 ? Vec3(0.8 * side.cross(direction)) : hand.normalized();
  return side + 0.62 * hand + 0.12 * up;
}

/// Unit vectors.
struct Sight {
  Vec3 back;  // from the target towards the eye
  Vec3 up;    // not along it
};

Sight sight_of(const Vec3& from) {
  const Vec3 back = from.normalized();
  return {back, std::abs(back.z()) > 0.98 ? Vec3::UnitY() : Vec3::UnitZ()};
}

Sight sight_of(const ViewPoint& from) {
  const double sa = std::sin(from.azimuth), ca = std::cos(from.azimuth);
  const double se = std::sin(from.elevation), ce = std::cos(from.elevation);
  return {Vec3(sa * ce, -ca * ce, se), Vec3(-sa * se, ca * se, ce)};
}

/// Moves the camera along its line of sight and sideways until all points just fit into the picture.
Camera framed(const std::vector<Vec3>& points, const Sight& sight, double aspect) {
  Camera camera;
  const Vec3 back = sight.back;
  camera.up = sight.up;
  const Vec3 right = camera.up.cross(back).normalized(), up = back.cross(right);
  constexpr double kMargin = 0.90;  // of half the picture
  const double half_high = kMargin * std::tan(camera.field_of_view / 2), half_wide = aspect * half_high;
  // A point is inside when |x - target.x| <= half_wide (distance - z) and likewise for y: the tightest of the
  // left and right (lower and upper) ones give the target and the distance of each axis.
  const auto fit = [&](const Vec3& axis, double half) {
    double plus = -kInfinity, minus = -kInfinity;
    for (const Vec3& p : points) {
      plus = std::max(plus, axis.dot(p) + half * back.dot(p));
      minus = std::max(minus, -axis.dot(p) + half * back.dot(p));
    }
    return std::pair{(plus - minus) / 2, (plus + minus) / (2 * half)};  // target, eye along `back`
  };
  const auto [x, eye_x] = fit(right, half_wide);
  const auto [y, eye_y] = fit(up, half_high);
  Bounds depth;
  for (const Vec3& p : points) depth.add(Vec3(0, 0, back.dot(p)));
  camera.target = x * right + y * up + (depth.lower.z() + depth.upper.z()) / 2 * back;
  camera.eye = x * right + y * up + std::max(eye_x, eye_y) * back;
  return camera;
}

/// The largest of 1, 2, 5 times a power of ten that is no longer than `length`.
double round_length(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  for (const double digit : {5.0, 2.0})
    if (digit * power <= length) return digit * power;
  return power;
}

}  // namespace

Stage set_stage(const Model& model, double aspect, const std::optional<ViewPoint>& from) {
  Stage stage;
  const Bounds bounds = bounds_of(model);
  std::vector<Vec3> points;
  for (const Body& body : model.bodies)
    for (const int node : body.surface->nodes) points.push_back(body.mesh->nodes[node]);
  for (const Probe& probe : model.probes) {
    const ProbeShape shape = shape_of(model, probe, bounds);
    const Vec3 end = probe.at - shape.radius * probe.direction;
    points.push_back(end + (shape.length + shape.radius) * shape.shaft);
    stage.probes.push_back(shape);
  }
  stage.camera = framed(points, from ? sight_of(*from) : sight_of(looks_from(model, stage.probes)), aspect);
  const double distance = (stage.camera.eye - stage.camera.target).norm();
  stage.scale_bar = round_length(0.2 * 2 * distance * std::tan(stage.camera.field_of_view / 2) * aspect);
  return stage;
}

}  // namespace palpate::sim
