#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_map>

#include "sim/mesh/parse_mesh.hpp"
#include "sim/mesh/volume.hpp"

namespace palpate::sim {
namespace {

constexpr double kWeldFraction = 1e-9;  // of the bounding box's diagonal
constexpr double kFarthest = 1e9;       // [m], keeps products of coordinates far from overflow
constexpr double kCellWidth = 16;       // in tolerances: wide, so that few points lie near a border

std::vector<bool> find_referenced(const TetMesh& mesh) {
  std::vector<bool> referenced(mesh.nodes.size(), false);
  for (const Tetrahedron& tetrahedron : mesh.tetrahedra)
    for (const int node : tetrahedron) referenced[node] = true;
  return referenced;
}

void scale(TetMesh& mesh, const std::string& name, double metres_per_unit) {
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    mesh.nodes[i] *= metres_per_unit;
    const double farthest = mesh.nodes[i].cwiseAbs().maxCoeff();
    if (!(farthest <= kFarthest))
      throw std::invalid_argument(
          fmt::format("{}: node {} lies {} m from the origin; up to {} m is accepted (was the unit right?)",
                      name, mesh.node_tags[i], farthest, kFarthest));
  }
}

Eigen::AlignedBox3d bounding_box(const TetMesh& mesh, const std::vector<bool>& referenced) {
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    if (referenced[i]) box.extend(mesh.nodes[i]);
  return box;
}

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t i : cell) hash = (hash ^ static_cast<std::uint64_t>(i)) * 0x9e3779b97f4a7c15U;
    return hash ^ (hash >> 32U);
  }
};

/// Nodes sorted into cubes; finds one within the tolerance of a point among those added so far.
struct Grid {
  double tolerance = 0.0;
  Vec3 origin = Vec3::Zero();
  std::unordered_map<Cell, std::vector<int>, CellHash> nodes;

  Cell cell_of(const Vec3& point) const {
    const Vec3 scaled = (point - origin) / (kCellWidth * tolerance);
    // A node far outside the tetrahedra is in none; its cell need not be told from its neighbours'.
    const auto index = [](double x) {
      return static_cast<std::int64_t>(std::floor(std::clamp(x, -1e18, 1e18)));
    };
    return {index(scaled.x()), index(scaled.y()), index(scaled.z())};
  }

  int find(const Vec3& point, const std::vector<Vec3>& positions) const {
    const Cell low = cell_of(point - Vec3::Constant(tolerance)),
               high = cell_of(point + Vec3::Constant(tolerance));
    for (std::int64_t x = low[0]; x <= high[0]; ++x)
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          const auto cell = nodes.find(Cell{x, y, z});
          if (cell == nodes.end()) continue;
          for (const int node : cell->second)
            if ((positions[node] - point).norm() <= tolerance) return node;
        }
    return -1;
  }
};

/// For each node the first one that lies within the tolerance of it: itself when there is none before.
std::vector<int> weld(const TetMesh& mesh, const Eigen::AlignedBox3d& box, double tolerance) {
  std::vector<int> twin(mesh.nodes.size());
  Grid grid{.tolerance = tolerance, .origin = box.min(), .nodes = {}};
  grid.nodes.reserve(mesh.nodes.size());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const int found = tolerance > 0 ? grid.find(mesh.nodes[i], mesh.nodes) : -1;
    twin[i] = found >= 0 ? found : static_cast<int>(i);
    if (found < 0 && tolerance > 0) grid.nodes[grid.cell_of(mesh.nodes[i])].push_back(static_cast<int>(i));
  }
  return twin;
}

void refuse_collapsed(const TetMesh& mesh, const std::vector<int>& twin, const std::string& name,
                      double tolerance) {
  for (const Tetrahedron& tetrahedron : mesh.tetrahedra)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const std::size_t a = tetrahedron[i], b = tetrahedron[j];
        if (twin[a] != twin[b]) continue;
        const auto tag = [&](std::size_t k) { return mesh.node_tags[tetrahedron[k]]; };
        throw std::invalid_argument(fmt::format(
            "{}: the tetrahedron of nodes {}, {}, {}, {} has no volume: its nodes {} and {} are one or lie "
            "within the weld tolerance of {:.3g} m; four separate nodes are accepted",
            name, tag(0), tag(1), tag(2), tag(3), tag(j), tag(i), tolerance));
      }
}

/// Keeps the nodes with keep[i], in their order; everything that names nodes follows through twin.
void renumber(TetMesh& mesh, const std::vector<int>& twin, const std::vector<bool>& keep) {
  std::vector<int> place(mesh.nodes.size(), -1);
  TetMesh kept;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    if (!keep[i]) continue;
    place[i] = static_cast<int>(kept.nodes.size());
    kept.nodes.push_back(mesh.nodes[i]);
    kept.node_tags.push_back(mesh.node_tags[i]);
  }
  const auto moved = [&](int node) { return place[twin[node]]; };
  for (Tetrahedron& tetrahedron : mesh.tetrahedra)
    for (int& node : tetrahedron) node = moved(node);
  for (auto& [name, nodes] : mesh.node_groups) {
    for (int& node : nodes) node = moved(node);
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    if (!nodes.empty() && nodes.front() < 0) nodes.erase(nodes.begin());
  }
  mesh.nodes = std::move(kept.nodes);
  mesh.node_tags = std::move(kept.node_tags);
}

int reorder_negative(TetMesh& mesh) {
  int reordered = 0;
  for (Tetrahedron& tetrahedron : mesh.tetrahedra) {
    if (signed_volume(mesh, tetrahedron) >= 0) continue;
    std::swap(tetrahedron[2], tetrahedron[3]);
    ++reordered;
  }
  return reordered;
}

}  // namespace

MeshFile mend(TetMesh mesh, const std::string& name, double metres_per_unit) {
  if (mesh.tetrahedra.empty())
    throw std::invalid_argument(fmt::format(
        "{}: holds no tetrahedron; a body filled with tetrahedra is accepted (gmsh -3 makes them; with "
        "physical groups, the volume needs one too, or Gmsh does not save it)",
        name));
  scale(mesh, name, metres_per_unit);
  const std::vector<bool> in_file = find_referenced(mesh);
  const Eigen::AlignedBox3d box = bounding_box(mesh, in_file);
  MeshRepairs repairs{.weld_tolerance = kWeldFraction * box.diagonal().norm()};

  const std::vector<int> twin = weld(mesh, box, repairs.weld_tolerance);
  refuse_collapsed(mesh, twin, name, repairs.weld_tolerance);
  std::vector<bool> keep(mesh.nodes.size(), false);
  for (std::size_t i = 0; i < twin.size(); ++i)
    if (in_file[i]) keep[twin[i]] = true;
  for (std::size_t i = 0; i < twin.size(); ++i) {
    const bool is_twin = twin[i] != static_cast<int>(i);
    repairs.welded_nodes += is_twin && keep[twin[i]];
    repairs.unreferenced_nodes += !keep[twin[i]];
  }
  renumber(mesh, twin, keep);
  repairs.reordered_tetrahedra = reorder_negative(mesh);
  return {.mesh = std::move(mesh), .repairs = repairs};
}

}  // namespace palpate::sim
