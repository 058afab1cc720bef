#include "sim/probe/slide/slide.hpp"

#include <limits>

#include "sim/surface/aabb_tree.hpp"
#include "sim/surface/barycentric.hpp"

namespace palpate::sim {
namespace {

/// Sets the knots about a place and their shares, all seen along the probe's direction; of triangles as near the first.
void find_knots(const Probe& probe, const Vec3& place, ProbeRow& row) {
  const Eigen::Matrix3d flat = Eigen::Matrix3d::Identity() - probe.direction * probe.direction.transpose();
  const Vec3 seen = flat * place;
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& triangle : probe.slide.triangles) {
    const auto corner = [&](std::size_t k) -> Vec3 { return flat * probe.slide.knots[triangle[k]].place; };
    const Vec3 a = corner(0), b = corner(1), c = corner(2);
    const Vec3 nearest = nearest_on_triangle(seen, a, b, c).point;
    const double squared = (nearest - seen).squaredNorm();
    if (squared >= least) continue;
    least = squared;
    row.knots = triangle;
    row.shares = barycentric(nearest, a, b, c);
  }
}

}  // namespace

void prescribe_sliding(const Probe& probe, const ProbeDisplacement& displacement, ProbeRow& row) {
  const Vec3 place = probe.slide.start + displacement.from_rest;
  find_knots(probe, place, row);
  Vec3 surface = Vec3::Zero();
  row.weights.setZero();
  row.compliance.setZero();
  for (std::size_t k = 0; k < row.knots.size(); ++k) {
    const Knot& knot = probe.slide.knots[row.knots[k]];
    const double share = row.shares[static_cast<Eigen::Index>(k)];
    surface += share * knot.place;
    row.weights += share * knot.weights;
    row.compliance += share * knot.compliance;
  }
  const double depth = (place - surface).dot(probe.direction);
  row.pressing = depth > 0.0;
  row.value.setZero();
  for (Eigen::Index k = 0; k < probe.axes.cols(); ++k)
    row.value[k] = depth * probe.axes.col(k).dot(probe.direction);
}

}  // namespace palpate::sim
