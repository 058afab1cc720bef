#include "tests/sim/mesh/fixtures.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "sim/mesh/parse_mesh.hpp"
#include "sim/mesh/surface.hpp"
#include "tests/support/places.hpp"

namespace palpate::sim::test {

std::filesystem::path data_file(const std::string& name) {
  return std::filesystem::path(palpate::test::source_folder()) / "tests/sim/mesh/data" / name;
}

std::string read_bytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error(file.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> two_boxes_files() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(data_file("")))
    if (const std::string name = entry.path().filename();
        name.starts_with("two_boxes.") && (name.ends_with(".msh") || name.ends_with(".vtu")))
      names.push_back(name);
  std::ranges::sort(names);
  return names;
}

TetMesh cube_mesh(int n, double side) {
  TetMesh mesh;
  const auto node = [&](int i, int j, int k) { return i + (n + 1) * (j + (n + 1) * k); };
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        mesh.nodes.push_back(side / n * Vec3(i, j, k));
        mesh.node_tags.push_back(node(i, j, k) + 1);
      }
  constexpr std::array<std::array<int, 3>, 6> kAxes = {
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  for (int cell = 0; cell < n * n * n; ++cell)
    for (std::size_t path = 0; path < 6; ++path) {  // from one corner to the opposite one along three edges
      std::array<int, 3> at = {cell % n, cell / n % n, cell / n / n};
      Tetrahedron t{node(at[0], at[1], at[2])};
      for (std::size_t i = 0; i < 3; ++i) {
        ++at[kAxes[path][i]];
        t[i + 1] = node(at[0], at[1], at[2]);
      }
      if (path >= 3) std::swap(t[2], t[3]);  // odd permutations of the axes turn the other way
      mesh.tetrahedra.push_back(t);
      mesh.region.push_back(-1);
    }
  return mesh;
}

std::string to_msh2(const TetMesh& mesh) {
  std::string text = fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n", mesh.nodes.size());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    text += fmt::format("{} {} {} {}\n", mesh.node_tags[i], mesh.nodes[i].x(), mesh.nodes[i].y(),
                        mesh.nodes[i].z());
  text += fmt::format("$EndNodes\n$Elements\n{}\n", mesh.tetrahedra.size());
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    text += fmt::format("{} 4 2 0 1", t + 1);
    for (const int node : mesh.tetrahedra[t]) text += fmt::format(" {}", mesh.node_tags[node]);
    text += "\n";
  }
  return text + "$EndElements\n";
}

std::string refusal(std::string_view bytes, const std::string& name) {
  try {
    parse_mesh(bytes, name, 1.0);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("the fixture does not hold '" + from + "'");
  return text.replace(at, from.size(), to);
}

double enclosed_volume(const TetMesh& mesh) {
  double volume = 0.0;
  for (const Triangle& t : extract_surface(mesh).triangles) {
    const auto at = [&](std::size_t i) -> const Vec3& { return mesh.nodes[t[i]]; };
    volume += at(0).dot(at(1).cross(at(2))) / 6.0;
  }
  return volume;
}

}  // namespace palpate::sim::test
