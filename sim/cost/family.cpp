#include "sim/cost/family.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "sim/compile/placed_mesh.hpp"
#include "sim/mesh/volume.hpp"
#include "sim/scene/refuse_key.hpp"

namespace palpate::sim {
namespace {

constexpr double kMostVolume = 0.15, kMostShift = 0.05;

struct Extent {
  double volume = 0.0;  // [m^3]
  Eigen::AlignedBox3d box{};
  std::size_t nodes = 0;
};

Extent extent_of(BodySpec spec, const std::filesystem::path& mesh) {
  spec.mesh = mesh;
  const TetMesh placed = read_placed(spec);
  Extent extent{.nodes = placed.nodes.size()};
  for (const Tetrahedron& tetrahedron : placed.tetrahedra)
    extent.volume += signed_volume(placed, tetrahedron);
  for (const Vec3& node : placed.nodes) extent.box.extend(node);
  return extent;
}

void require_finer(const BodySpec& body, const std::filesystem::path& mesh, const Extent& first,
                   const Extent& before, const Extent& here) {
  const auto refuse = [&](const std::string& what) {
    refuse_key(fmt::format("bodies.{}.refinements", body.name), fmt::format("{} {}", mesh.string(), what));
  };
  if (std::abs(here.volume / first.volume - 1) > kMostVolume)
    refuse(fmt::format(
        "is not the same body as {}: its volume is {:.3g} cm^3, there {:.3g}; accepted: within {:g} %",
        body.mesh.string(), 1e6 * here.volume, 1e6 * first.volume, 100 * kMostVolume));
  const double shift =
      std::max((here.box.min() - first.box.min()).norm(), (here.box.max() - first.box.max()).norm());
  if (shift > kMostShift * first.box.diagonal().norm())
    refuse(fmt::format(
        "is not the same body as {}: its corners lie {:.3g} mm from there; accepted: within {:.3g} mm",
        body.mesh.string(), 1e3 * shift, 1e3 * kMostShift * first.box.diagonal().norm()));
  if (here.nodes <= before.nodes)
    refuse(fmt::format("has {} nodes, and the mesh before it {}; accepted: each finer than the one before",
                       here.nodes, before.nodes));
}

}  // namespace

void require_one_body(const Scene& scene) {
  for (const BodySpec& body : scene.bodies) {
    if (body.refinements.empty() || !body.present) continue;
    const Extent first = extent_of(body, body.mesh);
    Extent before = first;
    for (const std::filesystem::path& mesh : body.refinements) {
      const Extent here = extent_of(body, mesh);
      require_finer(body, mesh, first, before, here);
      before = here;
    }
  }
}

}  // namespace palpate::sim
