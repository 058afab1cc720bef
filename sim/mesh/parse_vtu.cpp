#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <pugixml.hpp>
#include <stdexcept>

#include "sim/mesh/cursor.hpp"
#include "sim/mesh/parse_mesh.hpp"
#include "sim/mesh/vtu_array.hpp"

// Format: [VtkFileFormats], section "XML file formats", UnstructuredGrid.
namespace palpate::sim {
namespace {

constexpr std::int64_t kVertex = 1, kLine = 3, kTriangle = 5, kTetrahedron = 10;  // VTK's cell types
constexpr std::string_view kGroupPrefix = "group.";

/// Appended data may be raw bytes, which no XML parser takes: they are cut off before the rest is parsed.
std::string cut_appended(VtuFile& file) {
  const std::size_t tag = file.text.find("<AppendedData");
  if (tag == std::string_view::npos) return std::string(file.text);
  const std::size_t tag_end = file.text.find('>', tag), underscore = file.text.find('_', tag_end),
                    end = file.text.rfind("</AppendedData");
  if (tag_end == std::string_view::npos || underscore == std::string_view::npos ||
      end == std::string_view::npos || end < underscore)
    throw std::invalid_argument(
        fmt::format("{}: the file ends within <AppendedData>; it seems to be truncated", file.name));
  file.appended = file.text.substr(underscore + 1, end - underscore - 1);
  return std::string(file.text.substr(0, tag_end)) + "/></VTKFile>";
}

void read_encoding(VtuFile& file, const pugi::xml_node& root) {
  const std::string order = root.attribute("byte_order").as_string("LittleEndian");
  if (order != "LittleEndian" && order != "BigEndian")
    refuse(file, root,
           fmt::format("found byte_order '{}'; LittleEndian and BigEndian are accepted", printable(order)));
  file.swapped = (order == "BigEndian") != (std::endian::native == std::endian::big);

  const std::string header = root.attribute("header_type").as_string("UInt32");
  if (header != "UInt32" && header != "UInt64")
    refuse(file, root,
           fmt::format("found header_type '{}'; UInt32 and UInt64 are accepted", printable(header)));
  file.header_bytes = header == "UInt64" ? 8 : 4;

  const std::string compressor = root.attribute("compressor").value();
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
    refuse(file, root,
           fmt::format("found compressor '{}'; vtkZLibDataCompressor and none are accepted: save the file "
                       "again with zlib or without compression",
                       printable(compressor)));
  file.compressed = !compressor.empty();

  const pugi::xml_node appended = root.child("AppendedData");
  const std::string encoding = appended.attribute("encoding").as_string("raw");
  if (encoding != "raw" && encoding != "base64")
    refuse(file, appended,
           fmt::format("found encoding '{}'; raw and base64 are accepted", printable(encoding)));
  file.appended_is_base64 = encoding == "base64";
}

pugi::xml_node find_piece(const VtuFile& file, const pugi::xml_node& root) {
  if (std::string_view(root.name()) != "VTKFile" ||
      std::string_view(root.attribute("type").value()) != "UnstructuredGrid")
    refuse(file, root,
           fmt::format("found <{} type=\"{}\">; <VTKFile type=\"UnstructuredGrid\"> is accepted",
                       printable(root.name()), printable(root.attribute("type").value())));
  const pugi::xml_node grid = root.child("UnstructuredGrid"), piece = grid.child("Piece");
  if (!piece || piece.next_sibling("Piece"))
    refuse(file, grid ? grid : root,
           fmt::format("found {} pieces; one is accepted: join them and save again",
                       std::distance(grid.children("Piece").begin(), grid.children("Piece").end())));
  return piece;
}

std::int64_t read_count(const VtuFile& file, const pugi::xml_node& piece, const char* attribute) {
  std::int64_t count = -1;
  const char* text = piece.attribute(attribute).value();
  if (!parse_integer(text, count) || count < 0 || count > std::numeric_limits<int>::max())
    refuse(file, piece,
           fmt::format("found {}=\"{}\"; a whole number from 0 to 2147483647 is accepted", attribute,
                       printable(text)));
  return count;
}

pugi::xml_node find_array(const VtuFile& file, const pugi::xml_node& parent, const char* name) {
  const pugi::xml_node array = parent.find_child_by_attribute("DataArray", "Name", name);
  if (!array) refuse(file, parent, fmt::format("holds no DataArray named '{}'", name));
  return array;
}

template <class Number>
void expect_size(const VtuFile& file, const pugi::xml_node& array, const std::vector<Number>& values,
                 std::int64_t expected, const char* why) {
  if (static_cast<std::int64_t>(values.size()) != expected)
    refuse(file, array,
           fmt::format("array '{}' holds {} values; {} are accepted ({})",
                       printable(array.attribute("Name").value()), values.size(), expected, why));
}

void read_points(const VtuFile& file, const pugi::xml_node& piece, TetMesh& mesh) {
  const std::int64_t count = read_count(file, piece, "NumberOfPoints");
  const pugi::xml_node array = piece.child("Points").child("DataArray");
  if (!array) refuse(file, piece, "holds no <Points> with a DataArray");
  const std::vector<double> values = read_reals(file, array);
  expect_size(file, array, values, 3 * count, "three for each of NumberOfPoints");
  for (std::size_t i = 0; i < values.size(); i += 3) {
    mesh.node_tags.push_back(static_cast<std::int64_t>(i / 3));
    mesh.nodes.emplace_back(values[i], values[i + 1], values[i + 2]);
  }
}

[[noreturn]] void refuse_type(const VtuFile& file, const pugi::xml_node& at, std::size_t cell,
                              std::int64_t type) {
  refuse(
      file, at,
      fmt::format("cell {} is of VTK type {}; points, lines, triangles and 4-node tetrahedra (types 1, 3, 5, "
                  "10) are accepted: fill the body with first-order tetrahedra (ParaView's filter "
                  "Tetrahedralize makes them of linear cells)",
                  cell, type));
}

/// Appends the tetrahedra and returns their places among the cells.
std::vector<std::size_t> read_cells(const VtuFile& file, const pugi::xml_node& piece, TetMesh& mesh) {
  const std::int64_t count = read_count(file, piece, "NumberOfCells");
  const pugi::xml_node cells = piece.child("Cells");
  if (!cells) refuse(file, piece, "holds no <Cells>");
  const pugi::xml_node types_array = find_array(file, cells, "types"),
                       ends_array = find_array(file, cells, "offsets"),
                       nodes_array = find_array(file, cells, "connectivity");
  const std::vector<std::int64_t> types = read_integers(file, types_array),
                                  ends = read_integers(file, ends_array),
                                  nodes = read_integers(file, nodes_array);
  expect_size(file, types_array, types, count, "one for each of NumberOfCells");
  expect_size(file, ends_array, ends, count, "one for each of NumberOfCells");
  expect_size(file, nodes_array, nodes, ends.empty() ? 0 : ends.back(), "as the last offset says");

  std::vector<std::size_t> places;
  for (std::size_t c = 0; c < types.size(); ++c) {
    const std::int64_t begin = c == 0 ? 0 : ends[c - 1];
    if (begin < 0 || ends[c] < begin || ends[c] > static_cast<std::int64_t>(nodes.size()))
      refuse(file, ends_array,
             fmt::format("cell {} ends at {} after {}; offsets that rise to {} are accepted", c, ends[c],
                         begin, nodes.size()));
    if (types[c] == kVertex || types[c] == kLine || types[c] == kTriangle)
      continue;  // no part of a body's volume
    if (types[c] != kTetrahedron) refuse_type(file, types_array, c, types[c]);
    if (ends[c] - begin != 4)
      refuse(file, ends_array,
             fmt::format("tetrahedron {} has {} nodes; 4 are accepted", c, ends[c] - begin));
    Tetrahedron tetrahedron{};
    for (std::size_t i = 0; i < 4; ++i) {
      const std::int64_t node = nodes[begin + i];
      if (node < 0 || node >= static_cast<std::int64_t>(mesh.nodes.size()))
        refuse(file, nodes_array,
               fmt::format("cell {} names node {}; 0 to {} are accepted", c, node,
                           static_cast<std::int64_t>(mesh.nodes.size()) - 1));
      tetrahedron[i] = static_cast<int>(node);
    }
    mesh.tetrahedra.push_back(tetrahedron);
    places.push_back(c);
  }
  return places;
}

void read_groups(const VtuFile& file, const pugi::xml_node& piece, TetMesh& mesh) {
  for (const pugi::xml_node& array : piece.child("PointData").children("DataArray")) {
    const std::string_view name = array.attribute("Name").value();
    if (!name.starts_with(kGroupPrefix)) continue;
    const std::vector<std::int64_t> mask = read_integers(file, array);
    expect_size(file, array, mask, static_cast<std::int64_t>(mesh.nodes.size()),
                "one for each of NumberOfPoints");
    std::vector<int>& group = mesh.node_groups[std::string(name.substr(kGroupPrefix.size()))];
    for (std::size_t i = 0; i < mask.size(); ++i)
      if (mask[i] != 0) group.push_back(static_cast<int>(i));
  }
}

void read_regions(const VtuFile& file, const pugi::xml_node& piece, const std::vector<std::size_t>& places,
                  TetMesh& mesh) {
  mesh.region.assign(mesh.tetrahedra.size(), -1);
  const pugi::xml_node array = piece.child("CellData").find_child_by_attribute("DataArray", "Name", "region");
  if (!array) return;
  const std::vector<std::int64_t> ids = read_integers(file, array);
  expect_size(file, array, ids, read_count(file, piece, "NumberOfCells"), "one for each of NumberOfCells");
  std::map<std::int64_t, int> region_of_id;
  for (const std::size_t place : places)
    if (ids[place] >= 0) region_of_id[ids[place]] = -1;
  for (auto& [id, region] : region_of_id) {
    region = static_cast<int>(mesh.region_names.size());
    mesh.region_names.push_back(std::to_string(id));
  }
  for (std::size_t t = 0; t < places.size(); ++t)
    if (ids[places[t]] >= 0) mesh.region[t] = region_of_id.at(ids[places[t]]);
}

}  // namespace

TetMesh parse_vtu(std::string_view bytes, const std::string& name) {
  VtuFile file{.name = name, .text = bytes, .appended = {}};
  const std::string xml = cut_appended(file);
  pugi::xml_document document;
  const pugi::xml_parse_result parsed =
      document.load_buffer(xml.data(), xml.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!parsed) {
    const auto end = bytes.begin() +
                     std::clamp<std::ptrdiff_t>(parsed.offset, 0, static_cast<std::ptrdiff_t>(bytes.size()));
    throw std::invalid_argument(
        fmt::format("{}:{}: {}; whole, well-formed XML is accepted (is the file truncated?)", name,
                    1 + std::count(bytes.begin(), end, '\n'), parsed.description()));
  }
  const pugi::xml_node root = document.document_element();
  const pugi::xml_node piece = find_piece(file, root);
  read_encoding(file, root);
  TetMesh mesh;
  read_points(file, piece, mesh);
  const std::vector<std::size_t> places = read_cells(file, piece, mesh);
  read_groups(file, piece, mesh);
  read_regions(file, piece, places, mesh);
  return mesh;
}

}  // namespace palpate::sim
