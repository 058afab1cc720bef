#include "sim/compile/selection.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "sim/mesh/name_groups.hpp"
#include "sim/scene/refuse_key.hpp"

namespace palpate::sim {
namespace {

/// What groups there are, or how one is named.
std::string known_groups(const TetMesh& mesh) {
  std::vector<std::string> names;
  for (const auto& [name, nodes] : mesh.node_groups) names.push_back(name);
  if (!names.empty()) return fmt::format("it has: {}", fmt::join(names, ", "));
  return fmt::format("it has no named groups: {}; a list of node numbers and a box are accepted, too",
                     kHowToNameGroups);
}

std::string known_regions(const TetMesh& mesh) {
  if (!mesh.region_names.empty()) return fmt::format("it has: {}", fmt::join(mesh.region_names, ", "));
  return fmt::format("it has none: {}", kHowToNameRegions);
}

}  // namespace

std::vector<int> select(const TetMesh& mesh, const NodeSelection& selection, const std::string& key) {
  std::vector<int> nodes;
  if (const auto* group = std::get_if<std::string>(&selection)) {
    const auto found = mesh.node_groups.find(*group);
    if (found == mesh.node_groups.end())
      refuse_key(key, fmt::format("the mesh has no group \"{}\"; {}", *group, known_groups(mesh)));
    nodes = found->second;
  } else if (const auto* box = std::get_if<Box>(&selection)) {
    for (int i = 0; i < std::ssize(mesh.nodes); ++i)
      if ((mesh.nodes[i].array() >= box->lower.array()).all() &&
          (mesh.nodes[i].array() <= box->upper.array()).all())
        nodes.push_back(i);
  } else {
    for (const std::int64_t tag : std::get<std::vector<std::int64_t>>(selection)) {
      const auto found = std::ranges::find(mesh.node_tags, tag);
      if (found == mesh.node_tags.end()) refuse_key(key, fmt::format("the mesh has no node number {}", tag));
      nodes.push_back(static_cast<int>(found - mesh.node_tags.begin()));
    }
    std::ranges::sort(nodes);
  }
  if (nodes.empty()) refuse_key(key, "selects no node of the mesh");
  return nodes;
}

std::vector<Material> materials_of(const BodySpec& spec, const TetMesh& mesh) {
  std::vector<Material> materials(mesh.region_names.size() + 1, spec.material);
  for (const auto& [name, material] : spec.regions) {
    const auto found = std::ranges::find(mesh.region_names, name);
    if (found == mesh.region_names.end())
      refuse_key(fmt::format("bodies.{}.regions.{}", spec.name, name),
                 fmt::format("the mesh has no such volume group; {}", known_regions(mesh)));
    const auto region = static_cast<int>(found - mesh.region_names.begin());
    if (std::ranges::find(mesh.region, region) == mesh.region.end())
      refuse_key(
          fmt::format("bodies.{}.regions.{}", spec.name, name),
          "no tetrahedron of the mesh belongs to it: one that lies in several volume groups belongs to "
          "the smallest");
    materials[region + 1] = material;
  }
  return materials;
}

std::vector<int> without(const std::vector<int>& nodes, const std::vector<int>& left_out) {
  std::vector<int> kept;
  std::ranges::set_difference(nodes, left_out, std::back_inserter(kept));
  return kept;
}

std::vector<int> colliding_nodes(const BodySpec& spec, const TetMesh& mesh, const Surface& surface,
                                 const std::vector<int>& fixed) {
  std::vector<int> wanted = surface.nodes;
  if (spec.touchable) {
    const std::string key = fmt::format("bodies.{}.touchable", spec.name);
    const std::vector<int> named = select(mesh, *spec.touchable, key);
    wanted.clear();
    std::ranges::set_intersection(named, surface.nodes, std::back_inserter(wanted));
    if (wanted.empty()) refuse_key(key, "selects no node of the surface");
  }
  wanted = without(wanted, fixed);
  if (wanted.empty()) refuse_key(fmt::format("bodies.{}.touchable", spec.name), "selects fixed nodes only");
  return wanted;
}

}  // namespace palpate::sim
