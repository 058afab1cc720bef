#include "tests/sim/support/two_boxes.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>

#include "sim/compile/compile.hpp"
#include "sim/compliance/cache.hpp"
#include "sim/mesh/write_msh.hpp"
#include "tests/sim/support/body_table.hpp"
#include "tests/sim/support/box_mesh.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::sim::test {
namespace {

std::filesystem::path fresh_folder() {
  static const palpate::test::TemporaryFolder all;
  static int count = 0;
  const auto folder = all.path() / std::to_string(++count);
  std::filesystem::create_directory(folder);
  return folder;
}

/// The box's side faces as one group, so that a scene can hold all four.
TetMesh with_sides(TetMesh mesh) {
  mesh.node_groups["sides"] = nodes_of(mesh, {"x_min", "x_max", "y_min", "y_max"});
  return mesh;
}

constexpr const char* kProbe = R"([probes.finger]
body = "upper"
{probe}
at = ["{middle} m", "{middle} m", "{upper_top} m"]
direction = [0, 0, -1]
depth = "2 mm"
)";

constexpr const char* kThumb = R"([probes.thumb]
body = "lower"
kind = "point"
at = ["10 mm", "10 mm", "20 mm"]
direction = [0, 0, -1]
depth = "2 mm"
)";

}  // namespace

std::filesystem::path write_two_boxes(const TwoBoxes& boxes) {
  const auto folder = fresh_folder();
  const double side = 30e-3, height = 20e-3, thickness = 5e-3;  // [m]
  write_msh(folder / "upper.msh", with_sides(box_mesh(boxes.upper_divisions, boxes.upper_divisions, 2,
                                                      Vec3(side, side, thickness))));
  write_msh(folder / "lower.msh", box_mesh(boxes.divisions, boxes.divisions, 4, Vec3(side, side, height)));
  std::ofstream(folder / "scene.toml")
      << two_body_tables(
             body_table("upper", "sides", "z_min") +
                 fmt::format("offset = [\"{0} m\", \"{0} m\", \"{1} m\"]\n", boxes.shift, height + boxes.gap),
             body_table("lower", "z_min", "z_max"), "kuroda")
      << fmt::format(kProbe, fmt::arg("probe", boxes.probe), fmt::arg("middle", side / 2 + boxes.shift),
                     fmt::arg("upper_top", height + boxes.gap + thickness));
  if (boxes.second_probe) std::ofstream(folder / "scene.toml", std::ios::app) << kThumb;
  return folder / "scene.toml";
}

Model compile_scene(const std::filesystem::path& scene, std::span<const Override> overrides) {
  ComplianceCache cache({});
  return compile(load_scene(scene, overrides), cache);
}

}  // namespace palpate::sim::test
