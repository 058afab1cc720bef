#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include "sim/mesh/msh_content.hpp"

namespace palpate::sim {
namespace {

using TagAndIndex = std::pair<std::int64_t, int>;

std::vector<TagAndIndex> index_tags(const Cursor& in, const MshContent& content) {
  std::vector<TagAndIndex> sorted;
  sorted.reserve(content.node_tags.size());
  for (int i = 0; const std::int64_t tag : content.node_tags) sorted.emplace_back(tag, i++);
  std::ranges::sort(sorted);
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i].first == sorted[i - 1].first)
      in.refuse(content.nodes_offset,
                fmt::format("$Nodes gives node {} twice; each number is accepted once", sorted[i].first));
  return sorted;
}

/// Index of the node with a tag. Tags mostly count up from the first, so that place is tried first.
int find_node(const Cursor& in, const MshContent& content, const std::vector<TagAndIndex>& sorted,
              const MshElement& element, std::int64_t tag) {
  if (!sorted.empty() && tag >= sorted.front().first) {
    const std::size_t guess = tag - sorted.front().first;
    if (guess < sorted.size() && sorted[guess].first == tag) return sorted[guess].second;
    const auto found = std::ranges::lower_bound(sorted, TagAndIndex{tag, -1});
    if (found != sorted.end() && found->first == tag) return found->second;
  }
  if (sorted.empty())
    in.refuse(element.offset, fmt::format("found an element on node {}, and no node in a section $Nodes{}{}",
                                          tag, content.passed_over.empty() ? "" : "; not read: ",
                                          fmt::join(content.passed_over, ", ")));
  const std::string known = sorted.size() == 1 ? fmt::format("one node, numbered {}", sorted.front().first)
                                               : fmt::format("{} nodes, numbered {} to {}", sorted.size(),
                                                             sorted.front().first, sorted.back().first);
  in.refuse(element.offset, fmt::format("found an element on node {}; $Nodes holds {}", tag, known));
}

/// Named groups that the elements of one entity belong to.
struct EntityGroups {
  std::vector<std::vector<int>*> nodes;  // lists to add the elements' nodes to
  std::vector<int> regions;              // of a volume: indices into region_names
};

using GroupsOfEntity = std::map<DimensionAndTag, EntityGroups>;

GroupsOfEntity name_groups(const MshContent& content, TetMesh& mesh) {
  std::map<std::string, int> region_of_name;
  for (const auto& [key, name] : content.names) {
    mesh.node_groups[name];
    if (key.first != 3) continue;
    if (region_of_name.try_emplace(name, static_cast<int>(mesh.region_names.size())).second)
      mesh.region_names.push_back(name);
  }
  GroupsOfEntity groups;
  for (const auto& [entity, physical_tags] : content.physicals)
    for (const std::int64_t tag : physical_tags) {
      const auto name = content.names.find({entity.first, tag});
      if (name == content.names.end()) continue;  // a group without a name cannot be asked for
      groups[entity].nodes.push_back(&mesh.node_groups[name->second]);
      if (entity.first == 3) groups[entity].regions.push_back(region_of_name.at(name->second));
    }
  return groups;
}

/// A tetrahedron as it is listed: once, or in MSH 2.2 once for each of its physical groups.
struct Listing {
  Tetrahedron nodes{};
  Tetrahedron key{};  // the same, ascending
  const MshElement* element = nullptr;
  const EntityGroups* groups = nullptr;
};

std::vector<Listing> read_listings(const Cursor& in, const MshContent& content, GroupsOfEntity& groups) {
  const std::vector<TagAndIndex> sorted = index_tags(in, content);
  std::vector<Listing> listings;
  const MshElement* last = nullptr;
  EntityGroups* current = nullptr;
  for (const MshElement& element : content.elements) {
    if (!last || last->dimension != element.dimension || last->entity != element.entity)
      current = &groups[{element.dimension, element.entity}];
    last = &element;
    Tetrahedron nodes{};
    const std::size_t count = element.dimension + 1;
    for (std::size_t i = 0; i < count; ++i)
      nodes[i] = find_node(in, content, sorted, element, element.node_tags[i]);
    for (std::vector<int>* group : current->nodes)
      group->insert(group->end(), nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(count));
    if (element.dimension != 3) continue;
    listings.push_back({.nodes = nodes, .key = nodes, .element = &element, .groups = current});
    std::ranges::sort(listings.back().key);
  }
  return listings;
}

/// Orders regions by the number of tetrahedra listed in them, so that a nodule comes before the body around
/// it.
std::vector<int> ranks_by_size(const std::vector<Listing>& listings, std::size_t regions) {
  std::vector<std::pair<int, int>> sizes(regions);
  for (std::size_t r = 0; r < regions; ++r) sizes[r].second = static_cast<int>(r);
  for (const Listing& listing : listings)
    for (const int region : listing.groups->regions) ++sizes[region].first;
  std::ranges::sort(sizes);
  std::vector<int> ranks(regions);
  for (int rank = 0; const auto& [size, region] : sizes) ranks[region] = rank++;
  return ranks;
}

/// Index of the listing that each one repeats: itself for the first of its tetrahedron.
std::vector<std::size_t> find_first_listings(const Cursor& in, const std::vector<Listing>& listings) {
  std::vector<std::size_t> order(listings.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    const Listing &p = listings[a], &q = listings[b];
    return std::tie(p.key, p.element->entity, a) < std::tie(q.key, q.element->entity, b);
  });
  std::vector<std::size_t> first(order.size());
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    const Tetrahedron& key = listings[order[begin]].key;
    std::size_t earliest = order[begin];
    for (; end < order.size() && listings[order[end]].key == key; ++end) {
      const MshElement& element = *listings[order[end]].element;
      if (end > begin && listings[order[end - 1]].element->entity == element.entity)
        in.refuse(element.offset,
                  fmt::format("the tetrahedron of nodes {} is given twice; each is accepted once, or once "
                              "for each of its groups",
                              fmt::join(element.node_tags, ", ")));
      earliest = std::min(earliest, order[end]);
    }
    for (std::size_t i = begin; i < end; ++i) first[order[i]] = earliest;
  }
  return first;
}

void add_tetrahedra(const Cursor& in, const std::vector<Listing>& listings, TetMesh& mesh) {
  const std::vector<int> ranks = ranks_by_size(listings, mesh.region_names.size());
  const auto rank = [&](int region) { return region < 0 ? std::numeric_limits<int>::max() : ranks[region]; };
  const std::vector<std::size_t> first = find_first_listings(in, listings);
  std::vector<std::size_t> place(listings.size());
  for (std::size_t i = 0; i < listings.size(); ++i) {
    if (first[i] == i) {
      place[i] = mesh.tetrahedra.size();
      mesh.tetrahedra.push_back(listings[i].nodes);
      mesh.region.push_back(-1);
    }
    int& region = mesh.region[place[first[i]]];
    for (const int candidate : listings[i].groups->regions)
      if (rank(candidate) < rank(region)) region = candidate;
  }
}

}  // namespace

TetMesh assemble(const Cursor& in, const MshContent& content) {
  TetMesh mesh;
  mesh.nodes = content.nodes;
  mesh.node_tags = content.node_tags;
  GroupsOfEntity groups = name_groups(content, mesh);
  add_tetrahedra(in, read_listings(in, content, groups), mesh);
  for (auto& [name, nodes] : mesh.node_groups) {
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  }
  return mesh;
}

}  // namespace palpate::sim
