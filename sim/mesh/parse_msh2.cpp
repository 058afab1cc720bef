#include <fmt/format.h>

#include <cstdlib>

#include "sim/mesh/msh_content.hpp"

namespace palpate::sim {
namespace {

MshElement read_tail(Cursor& in, int dimension, std::int64_t tags, std::size_t offset) {
  MshElement element{.dimension = dimension, .offset = offset};
  for (std::int64_t i = 0; i < tags; ++i) {
    const std::int64_t tag = in.integer("an element's tag");
    if (i == 0) element.entity = std::abs(tag);  // the sign tells a reversed orientation
  }
  for (std::size_t i = 0; i <= static_cast<std::size_t>(dimension); ++i)
    element.node_tags[i] = in.integer("a node of an element");
  return element;
}

/// The tags of an element are read and passed over one by one, so a false count ends at the end of the file.
std::int64_t read_tag_count(Cursor& in) {
  const std::int64_t tags = in.integer("an element's number of tags");
  in.claim(tags, 1, 4, "tags of an element");
  return tags;
}

void read_text_elements(Cursor& in, std::size_t count, MshContent& content) {
  for (std::size_t i = 0; i < count; ++i) {
    in.text_integer("an element's number");
    const std::size_t offset = in.here();
    const int dimension = msh_dimension(in, in.text_integer("an element's type"));
    content.elements.push_back(read_tail(in, dimension, read_tag_count(in), offset));
  }
}

void read_binary_elements(Cursor& in, std::size_t count, MshContent& content) {
  for (std::size_t read = 0; read < count;) {
    const int dimension = msh_dimension(in, in.integer("an element block's type"));
    const std::int64_t block = in.integer("an element block's size");
    const std::int64_t tags = in.integer("an element block's number of tags");
    if (tags < 0 || block < 1 || static_cast<std::size_t>(block) > count - read)
      in.refuse_last(fmt::format("found a block of {} elements with {} tags each; {} elements are left of {}",
                                 block, tags, count - read, count));
    in.claim(block, 1, 4 * (1 + tags + dimension + 1), "elements of a block");
    for (std::int64_t i = 0; i < block; ++i) {
      const std::size_t offset = in.here();
      in.integer("an element's number");
      content.elements.push_back(read_tail(in, dimension, tags, offset));
    }
    read += block;
  }
}

}  // namespace

void read_msh2_nodes(Cursor& in, MshContent& content) {
  content.nodes_offset = in.here();
  const std::size_t count = in.claim(in.text_integer("the number of nodes"), 4, 28, "nodes");
  in.end_of_line();
  content.node_tags.reserve(content.node_tags.size() + count);
  content.nodes.reserve(content.nodes.size() + count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t tag = in.integer("a node's number");
    if (tag < 0) in.refuse_last(fmt::format("found node number {}; numbers from 0 are accepted", tag));
    content.node_tags.push_back(tag);
    const double x = in.real("a node's x"), y = in.real("a node's y"), z = in.real("a node's z");
    content.nodes.emplace_back(x, y, z);
  }
}

void read_msh2_elements(Cursor& in, MshContent& content) {
  const std::size_t count = in.claim(in.text_integer("the number of elements"), 4, 8, "elements");
  in.end_of_line();
  content.elements.reserve(content.elements.size() + count);
  in.binary() ? read_binary_elements(in, count, content) : read_text_elements(in, count, content);
  const MshElement* last = nullptr;  // elements of one group stand together
  for (const MshElement& element : content.elements) {
    const bool known = last && last->entity == element.entity && last->dimension == element.dimension;
    if (element.entity != 0 && !known)
      content.physicals[{element.dimension, element.entity}] = {element.entity};
    last = &element;
  }
}

}  // namespace palpate::sim
