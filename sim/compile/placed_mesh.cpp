#include "sim/compile/placed_mesh.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <stdexcept>

#include "sim/mesh/quality.hpp"
#include "sim/mesh/read_mesh.hpp"
#include "sim/scene/refuse_key.hpp"

namespace palpate::sim {
namespace {

constexpr double kLeastBody = 1e-6, kFarthest = 1e9;  // [m] across, and from the origin

/// A body that scale, offset or rotate have taken to where numbers have no meaning left.
void refuse_misplaced(const BodySpec& spec, const TetMesh& mesh) {
  Vec3 lower = mesh.nodes.front(), upper = lower;
  for (const Vec3& node : mesh.nodes) {
    if (!(node.cwiseAbs().maxCoeff() <= kFarthest))
      refuse_key(
          fmt::format("bodies.{}", spec.name),
          fmt::format("scale, offset or rotate put it at ({:g}, {:g}, {:g}) m; accepted: up to {:g} m from "
                      "the origin",
                      node.x(), node.y(), node.z(), kFarthest));
    lower = lower.cwiseMin(node);
    upper = upper.cwiseMax(node);
  }
  if (const double across = (upper - lower).norm(); across < kLeastBody)
    refuse_key(fmt::format("bodies.{}", spec.name),
               fmt::format("is {:g} m across; accepted: {:g} m or more; look at length_unit and scale",
                           across, kLeastBody));
}

}  // namespace

TetMesh read_placed(const BodySpec& spec) {
  TetMesh mesh;
  try {
    mesh = read_mesh(spec.mesh, spec.metres_per_unit).mesh;
  } catch (const std::invalid_argument& error) {
    refuse_key(fmt::format("bodies.{}.mesh", spec.name), error.what());
  }
  try {
    validate(mesh);
  } catch (const std::invalid_argument& error) {
    refuse_key(fmt::format("bodies.{}.mesh", spec.name),
               fmt::format("{}: {}", spec.mesh.string(), error.what()));
  }
  const double angle = spec.rotate.norm();
  const Eigen::Matrix3d turn = angle > 0.0 ? Eigen::AngleAxisd(angle, spec.rotate / angle).toRotationMatrix()
                                           : Eigen::Matrix3d::Identity();
  for (Vec3& node : mesh.nodes) node = turn * (spec.scale * node) + spec.offset;
  refuse_misplaced(spec, mesh);
  return mesh;
}

}  // namespace palpate::sim
