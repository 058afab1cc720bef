#include "sim/mesh/write_msh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "base/files/atomic_file.hpp"
#include "sim/mesh/cursor.hpp"

// Format: [Geuzaine2009] and Gmsh's manual, "MSH file format" version 4.1. Every body is a discrete volume; a
// node of a group is a discrete point with one point element, since MSH has no groups of nodes.
namespace palpate::sim {
namespace {

constexpr int kGmshPoint = 15, kGmshTetrahedron = 4;  // Gmsh's element types

using Out = std::back_insert_iterator<fmt::memory_buffer>;

/// A volume's nodes are its group already when it is read; only a group that has others is written by its
/// nodes.
bool follows_from_region(const TetMesh& mesh, const std::string& name, const std::vector<int>& group) {
  const auto region = std::ranges::find(mesh.region_names, name);
  if (region == mesh.region_names.end()) return false;
  std::vector<int> nodes;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    if (mesh.region[t] == region - mesh.region_names.begin())
      nodes.insert(nodes.end(), mesh.tetrahedra[t].begin(), mesh.tetrahedra[t].end());
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes == group;
}

/// Tags as MSH wants them: positive and each once. Those of the file where they are so, else counted from 1.
std::vector<std::int64_t> node_tags_for_msh(const TetMesh& mesh) {
  std::vector<std::int64_t> sorted = mesh.node_tags;
  std::ranges::sort(sorted);
  const bool usable = sorted.size() == mesh.nodes.size() && (sorted.empty() || sorted.front() > 0) &&
                      std::ranges::adjacent_find(sorted) == sorted.end();
  if (usable) return mesh.node_tags;
  std::vector<std::int64_t> tags(mesh.nodes.size());
  for (std::size_t i = 0; i < tags.size(); ++i) tags[i] = static_cast<std::int64_t>(i) + 1;
  return tags;
}

struct PointGroups {
  std::vector<std::string> names;           // physical tag: place + 1
  std::map<int, std::vector<int>> of_node;  // physical tags of each node that is in a group
};

PointGroups collect_point_groups(const TetMesh& mesh) {
  PointGroups groups;
  for (const auto& [name, nodes] : mesh.node_groups) {
    if (follows_from_region(mesh, name, nodes)) continue;
    groups.names.push_back(name);
    for (const int node : nodes) groups.of_node[node].push_back(static_cast<int>(groups.names.size()));
  }
  return groups;
}

void write_names(Out out, const TetMesh& mesh, const PointGroups& groups) {
  fmt::format_to(out, "$PhysicalNames\n{}\n", groups.names.size() + mesh.region_names.size());
  const auto write = [&](int dimension, std::size_t tag, const std::string& name) {
    if (name.empty() || name.find_first_of("\"\r\n") != std::string::npos)
      throw std::invalid_argument(
          fmt::format("group '{}': MSH accepts names without quotes and line breaks", printable(name)));
    fmt::format_to(out, "{} {} \"{}\"\n", dimension, tag, name);
  };
  for (std::size_t i = 0; i < groups.names.size(); ++i) write(0, i + 1, groups.names[i]);
  for (std::size_t i = 0; i < mesh.region_names.size(); ++i) write(3, i + 1, mesh.region_names[i]);
  fmt::format_to(out, "$EndPhysicalNames\n");
}

/// Volume 1 + r is region r; the last one holds the tetrahedra of none.
std::size_t volume_of(const TetMesh& mesh, std::size_t tetrahedron) {
  const int region = mesh.region.empty() ? -1 : mesh.region[tetrahedron];
  return region < 0 ? mesh.region_names.size() + 1 : region + 1;
}

void write_entities(Out out, const TetMesh& mesh, const PointGroups& groups,
                    const std::vector<std::int64_t>& tags) {
  Vec3 low = mesh.nodes.front(), high = low;
  for (const Vec3& x : mesh.nodes) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  fmt::format_to(out, "$Entities\n{} 0 0 {}\n", groups.of_node.size(), mesh.region_names.size() + 1);
  for (int entity = 1; const auto& [node, physicals] : groups.of_node) {
    const Vec3& x = mesh.nodes[node];
    fmt::format_to(out, "{} {} {} {} {} {}\n", entity++, x.x(), x.y(), x.z(), physicals.size(),
                   fmt::join(physicals, " "));
  }
  for (std::size_t volume = 1; volume <= mesh.region_names.size() + 1; ++volume) {
    const std::string physical = volume <= mesh.region_names.size() ? fmt::format("1 {}", volume) : "0";
    fmt::format_to(out, "{} {} {} {} {} {} {} {} 0\n", volume, low.x(), low.y(), low.z(), high.x(), high.y(),
                   high.z(), physical);
  }
  fmt::format_to(out, "$EndEntities\n");
  const auto [least, most] = std::minmax_element(tags.begin(), tags.end());
  fmt::format_to(out, "$Nodes\n1 {0} {1} {2}\n3 1 0 {0}\n", tags.size(), *least, *most);
  for (const std::int64_t tag : tags) fmt::format_to(out, "{}\n", tag);
  for (const Vec3& x : mesh.nodes) fmt::format_to(out, "{} {} {}\n", x.x(), x.y(), x.z());
  fmt::format_to(out, "$EndNodes\n");
}

/// Tetrahedra keep their order: one block for each run of them in the same volume.
std::vector<std::size_t> run_starts(const TetMesh& mesh) {
  std::vector<std::size_t> starts;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    if (t == 0 || volume_of(mesh, t) != volume_of(mesh, t - 1)) starts.push_back(t);
  starts.push_back(mesh.tetrahedra.size());
  return starts;
}

void write_elements(Out out, const TetMesh& mesh, const PointGroups& groups,
                    const std::vector<std::int64_t>& tags) {
  const std::vector<std::size_t> starts = run_starts(mesh);
  const std::size_t count = groups.of_node.size() + mesh.tetrahedra.size();
  fmt::format_to(out, "$Elements\n{} {} 1 {}\n", groups.of_node.size() + starts.size() - 1, count, count);
  std::size_t element = 1;
  for (int entity = 1; const auto& [node, physicals] : groups.of_node)
    fmt::format_to(out, "0 {} {} 1\n{} {}\n", entity++, kGmshPoint, element++, tags[node]);
  for (std::size_t run = 0; run + 1 < starts.size(); ++run) {
    fmt::format_to(out, "3 {} {} {}\n", volume_of(mesh, starts[run]), kGmshTetrahedron,
                   starts[run + 1] - starts[run]);
    for (std::size_t t = starts[run]; t < starts[run + 1]; ++t) {
      fmt::format_to(out, "{}", element++);
      for (const int node : mesh.tetrahedra[t]) fmt::format_to(out, " {}", tags[node]);
      fmt::format_to(out, "\n");
    }
  }
  fmt::format_to(out, "$EndElements\n");
}

}  // namespace

void write_msh(const std::filesystem::path& file, const TetMesh& mesh) {
  if (mesh.tetrahedra.empty())
    throw std::invalid_argument("a mesh without tetrahedra cannot be written as MSH");
  const PointGroups groups = collect_point_groups(mesh);
  const std::vector<std::int64_t> tags = node_tags_for_msh(mesh);
  fmt::memory_buffer text;
  const Out out(text);
  fmt::format_to(out, "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
  if (!groups.names.empty() || !mesh.region_names.empty()) write_names(out, mesh, groups);
  write_entities(out, mesh, groups, tags);
  write_elements(out, mesh, groups, tags);
  base::write_atomically(file, {text.data(), text.size()});
}

}  // namespace palpate::sim
