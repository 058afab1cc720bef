#include <fmt/format.h>

#include <cstdlib>

#include "sim/mesh/msh_content.hpp"

namespace palpate::sim {
namespace {

void read_entity(Cursor& in, int dimension, MshContent& content) {
  const std::int64_t tag = in.integer("an entity's tag");
  for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) in.real("an entity's bounds");
  const std::size_t physicals =
      in.claim(in.size("an entity's number of physical tags"), 1, 4, "physical tags");
  std::vector<std::int64_t>& tags = content.physicals[{dimension, tag}];
  for (std::size_t i = 0; i < physicals; ++i)
    tags.push_back(std::abs(in.integer("a physical tag")));  // the sign tells a reversed orientation
  if (dimension == 0) return;
  const std::size_t bounds =
      in.claim(in.size("an entity's number of bounding entities"), 1, 4, "bounding entities");
  for (std::size_t i = 0; i < bounds; ++i) in.integer("a bounding entity's tag");
}

int read_dimension(Cursor& in) {
  const std::int64_t dimension = in.integer("an entity's dimension");
  if (dimension < 0 || dimension > 3)
    in.refuse_last(fmt::format("found {} as an entity's dimension; 0 to 3 are accepted", dimension));
  return static_cast<int>(dimension);
}

struct Totals {
  std::int64_t blocks = 0, records = 0;
};

Totals read_totals(Cursor& in, std::int64_t numbers, std::int64_t binary_bytes, const char* what) {
  Totals totals;
  totals.blocks = in.size("the number of entity blocks");
  in.claim(totals.blocks, 4, 20, "entity blocks");
  totals.records = in.size("a total number of records");
  in.claim(totals.records, numbers, binary_bytes, what);
  in.size("the smallest tag");
  in.size("the largest tag");
  return totals;
}

void check_total(const Cursor& in, std::int64_t found, const Totals& totals, const char* what) {
  if (found != totals.records)
    in.refuse_last(fmt::format("found {} {} in {} entity blocks; the section's first line claims {}", found,
                               what, totals.blocks, totals.records));
}

}  // namespace

void read_msh4_entities(Cursor& in, MshContent& content) {
  std::array<std::int64_t, 4> counts{};
  for (std::int64_t& count : counts) count = in.size("a number of entities");
  for (int dimension = 0; dimension < 4; ++dimension) {
    const std::int64_t count = counts[dimension];
    in.claim(count, dimension == 0 ? 5 : 9, dimension == 0 ? 36 : 68, "entities");
    for (std::int64_t i = 0; i < count; ++i) read_entity(in, dimension, content);
  }
}

void read_msh4_nodes(Cursor& in, MshContent& content) {
  content.nodes_offset = in.here();
  const Totals totals = read_totals(in, 4, 32, "nodes");
  content.node_tags.reserve(totals.records);
  content.nodes.reserve(totals.records);
  std::int64_t total = 0;
  for (std::int64_t block = 0; block < totals.blocks; ++block) {
    const int dimension = read_dimension(in);
    in.integer("an entity's tag");
    const int parameters = in.integer("whether nodes are parametric") != 0 ? dimension : 0;
    const std::size_t count = in.claim(in.size("a block's number of nodes"), 4 + parameters,
                                       8 * (4 + parameters), "nodes of a block");
    for (std::size_t i = 0; i < count; ++i) content.node_tags.push_back(in.size("a node's tag"));
    for (std::size_t i = 0; i < count; ++i) {
      const double x = in.real("a node's x"), y = in.real("a node's y"), z = in.real("a node's z");
      content.nodes.emplace_back(x, y, z);
      for (int j = 0; j < parameters; ++j) in.real("a node's parameter");
    }
    total += static_cast<std::int64_t>(count);
  }
  check_total(in, total, totals, "nodes");
}

void read_msh4_elements(Cursor& in, MshContent& content) {
  const Totals totals = read_totals(in, 2, 16, "elements");
  content.elements.reserve(totals.records);
  std::int64_t total = 0;
  for (std::int64_t block = 0; block < totals.blocks; ++block) {
    read_dimension(in);  // the elements' type tells it as well
    const std::int64_t entity = in.integer("an entity's tag");
    const int dimension = msh_dimension(in, in.integer("a block's element type"));
    const std::size_t count = in.claim(in.size("a block's number of elements"), 2 + dimension,
                                       8 * (2 + dimension), "elements of a block");
    for (std::size_t i = 0; i < count; ++i) {
      MshElement element{.dimension = dimension, .entity = entity, .offset = in.here()};
      in.size("an element's tag");
      for (std::size_t j = 0; j <= static_cast<std::size_t>(dimension); ++j)
        element.node_tags[j] = in.size("a node of an element");
      content.elements.push_back(element);
    }
    total += static_cast<std::int64_t>(count);
  }
  check_total(in, total, totals, "elements");
}

}  // namespace palpate::sim
