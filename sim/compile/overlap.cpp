#include "sim/compile/overlap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "sim/pairing/find_pairs.hpp"
#include "sim/scene/refuse_key.hpp"

namespace palpate::sim {
namespace {

/// Deepest place of a node of `inner` inside `outer` at rest, over the whole boundary of both.
double overlap_at_rest(const Body& inner, const Body& outer) {
  const auto nodes = static_cast<int>(outer.mesh->nodes.size());
  std::vector<int> every(outer.mesh->nodes.size());
  std::iota(every.begin(), every.end(), 0);
  Body whole{.polygons = make_touch_surface(outer.surface->triangles, every, nodes)};
  whole.rest.resize(3, nodes);
  for (int i = 0; i < nodes; ++i) whole.rest.col(i) = outer.mesh->nodes[i];
  whole.tree = build_tree(whole.polygons.triangles, whole.rest);

  Body points;
  points.rest.resize(3, static_cast<Eigen::Index>(inner.surface->nodes.size()));
  for (int i = 0; i < std::ssize(inner.surface->nodes); ++i) {
    points.rest.col(i) = inner.mesh->nodes[inner.surface->nodes[i]];
    points.colliding_nodes.push_back(i);
  }
  Model probe_model;
  probe_model.bodies = {std::move(points), std::move(whole)};
  probe_model.pairs = {{{0, 1}}};
  FreeMotion motion(2);  // as if the nodes had come from infinity: they look at every polygon
  motion[0].displacement = Eigen::VectorXd::Constant(3 * probe_model.bodies[0].rest.cols(),
                                                     std::numeric_limits<double>::infinity());
  motion[0].moved = true;
  return deepest_overlaps(probe_model, motion, rest_placement(probe_model)).front();
}

}  // namespace

void refuse_overlap(const Body& a, const Body& b) {
  const double size = (a.rest.rowwise().maxCoeff() - a.rest.rowwise().minCoeff()).norm();
  const double overlap = std::max(overlap_at_rest(a, b), overlap_at_rest(b, a));
  if (overlap > 1e-9 * size)
    refuse_key(
        "bodies",
        fmt::format("{} and {} overlap at rest by {:.3g} mm; accepted: bodies that are apart (see offset)",
                    a.name, b.name, 1e3 * overlap));
}

}  // namespace palpate::sim
