#include "tests/sim/support/region_boxes.hpp"

#include <fmt/format.h>

#include <fstream>

#include "sim/mesh/write_msh.hpp"
#include "tests/sim/support/box_mesh.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::sim::test {

std::filesystem::path write_region_boxes(const std::string& upper, const std::string& lower,
                                         const std::string& contact, const std::string& probes) {
  static const palpate::test::TemporaryFolder all;
  static int count = 0;
  const std::filesystem::path folder = all.path() / std::to_string(++count);
  std::filesystem::create_directory(folder);
  write_msh(folder / "upper.msh", shaken(box_mesh(4, 4, 3, Vec3(12e-3, 12e-3, 9e-3)), 0.2e-3, 3));
  write_msh(folder / "lower.msh", box_mesh(7, 7, 3, Vec3(35e-3, 35e-3, 12e-3)));
  std::ofstream(folder / "scene.toml") << "name = \"regions\"\n"
                                       << upper << "offset = [\"11.3 mm\", \"11.1 mm\", \"12.2 mm\"]\n"
                                       << lower << contact << probes;
  return folder / "scene.toml";
}

std::string without_fixed(std::string table) {
  const auto at = table.find("fixed =");
  return table.erase(at, table.find('\n', at) + 1 - at);
}

std::string region_table(const std::string& name, const std::string& body, const std::string& group,
                         const std::string& reach) {
  return fmt::format(
             "[probes.{}]\nbody = \"{}\"\nkind = \"region\"\ngroup = \"{}\"\ndirection = [0, 0, -1]\ndepth = \"2 "
             "mm\"\n",
             name, body, group) +
         (reach.empty() ? "" : fmt::format("reach = \"{}\"\n", reach));
}

}  // namespace palpate::sim::test
