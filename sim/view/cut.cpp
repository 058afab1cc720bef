#include "sim/view/cut.hpp"

#include <cassert>
#include <stdexcept>

#include "sim/mesh/surface.hpp"

namespace palpate::sim {
namespace {

constexpr double kAlong = 0.2;  // of the line of sight, that must be left across the press

struct Plane {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  // towards the camera
};

Plane plane_of_press(const Picture& picture, const Probe& probe) {
  const Vec3 back = (picture.camera.eye - picture.camera.target).normalized();
  const Vec3 across = back - back.dot(probe.direction) * probe.direction;
  if (across.norm() < kAlong)
    throw std::invalid_argument(
        "the view looks along the press, and a cut through it would not be seen; "
        "accepted: a view from aside");
  return {probe.at, across.normalized()};
}

DrawnBody opened(const DrawnBody& drawn, const TetMesh& mesh, const WholeBody& whole, const Plane& plane) {
  TetMesh rest{.nodes = mesh.nodes};
  std::vector<int> kept;  // tetrahedra of the mesh
  for (int t = 0; t < std::ssize(mesh.tetrahedra); ++t) {
    Vec3 middle = Vec3::Zero();
    for (const int node : mesh.tetrahedra[t]) middle += mesh.nodes[node] / 4;
    if ((middle - plane.point).dot(plane.normal) > 0) continue;
    kept.push_back(t);
    rest.tetrahedra.push_back(mesh.tetrahedra[t]);
  }
  Surface surface = extract_surface(rest);
  for (int& tetrahedron : surface.behind) tetrahedron = kept[tetrahedron];
  DrawnBody open = drawn;
  open.opacity = 1.0F;
  open.triangles = std::move(surface.triangles);
  open.behind = std::move(surface.behind);
  for (Eigen::Index node = 0; node < open.positions.cols(); ++node)  // those inside are seen now
    open.positions.col(node) = (mesh.nodes[node] + whole.displacement.col(node)).cast<float>();
  return open;
}

}  // namespace

void cut_open(Picture& picture, const Model& model, std::span<const WholeBody> bodies) {
  assert(picture.bodies.size() == model.bodies.size() && bodies.size() == model.bodies.size());
  const Plane plane = plane_of_press(picture, model.probes.front());
  for (std::size_t body = 0; body < bodies.size(); ++body)
    picture.bodies[body] = opened(picture.bodies[body], *model.bodies[body].mesh, bodies[body], plane);
}

}  // namespace palpate::sim
