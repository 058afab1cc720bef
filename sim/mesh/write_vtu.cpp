#include "sim/mesh/write_vtu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <stdexcept>

#include "base/files/atomic_file.hpp"
#include "sim/mesh/cursor.hpp"

// Format: [VtkFileFormats], section "XML file formats", UnstructuredGrid. Numbers are the shortest that read
// back as the same double.
namespace palpate::sim {
namespace {

constexpr int kVtkTetrahedron = 10;

using Out = std::back_insert_iterator<fmt::memory_buffer>;

std::string escape(const std::string& name) {
  std::string out;
  for (const char c : name) {
    if (static_cast<unsigned char>(c) < 0x20)
      throw std::invalid_argument(
          fmt::format("group '{}': VTU accepts names without control characters", printable(name)));
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

template <class WriteValues>
void write_array(Out out, const char* type, const std::string& name, int components,
                 WriteValues&& write_values) {
  fmt::format_to(out, "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n",
                 type, escape(name), components);
  write_values();
  fmt::format_to(out, "</DataArray>\n");
}

void write_point_data(Out out, const TetMesh& mesh, const VtuFields& fields) {
  fmt::format_to(out, "<PointData>\n");
  for (const auto& field : fields.point_vectors) {  // clang 14 captures no structured bindings
    const Eigen::Matrix3Xd& vectors = field.second;
    assert(vectors.cols() == static_cast<Eigen::Index>(mesh.nodes.size()));
    write_array(out, "Float64", field.first, 3, [&] {
      for (const auto& v : vectors.colwise()) fmt::format_to(out, "{} {} {}\n", v.x(), v.y(), v.z());
    });
  }
  for (const auto& group : mesh.node_groups)
    write_array(out, "UInt8", "group." + group.first, 1, [&] {
      const std::vector<int>& nodes = group.second;
      for (int i = 0; i < static_cast<int>(mesh.nodes.size()); ++i)
        fmt::format_to(out, "{}\n", std::ranges::binary_search(nodes, i) ? 1 : 0);
    });
  fmt::format_to(out, "</PointData>\n");
}

void write_cell_data(Out out, const TetMesh& mesh, const VtuFields& fields) {
  fmt::format_to(out, "<CellData>\n");
  for (const auto& field : fields.cell_scalars) {
    const Eigen::VectorXd& scalars = field.second;
    assert(scalars.size() == static_cast<Eigen::Index>(mesh.tetrahedra.size()));
    write_array(out, "Float64", field.first, 1, [&] {
      for (const double value : scalars) fmt::format_to(out, "{}\n", value);
    });
  }
  if (!mesh.region.empty())
    write_array(out, "Int32", "region", 1, [&] {
      for (const int region : mesh.region) fmt::format_to(out, "{}\n", region);
    });
  fmt::format_to(out, "</CellData>\n");
}

void write_cells(Out out, const TetMesh& mesh) {
  fmt::format_to(out, "<Cells>\n");
  write_array(out, "Int64", "connectivity", 1, [&] {
    for (const Tetrahedron& t : mesh.tetrahedra) fmt::format_to(out, "{} {} {} {}\n", t[0], t[1], t[2], t[3]);
  });
  write_array(out, "Int64", "offsets", 1, [&] {
    for (std::size_t t = 1; t <= mesh.tetrahedra.size(); ++t) fmt::format_to(out, "{}\n", 4 * t);
  });
  write_array(out, "UInt8", "types", 1, [&] {
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) fmt::format_to(out, "{}\n", kVtkTetrahedron);
  });
  fmt::format_to(out, "</Cells>\n");
}

}  // namespace

std::string vtu_text(const TetMesh& mesh, const VtuFields& fields) {
  fmt::memory_buffer text;
  const Out out(text);
  fmt::format_to(out,
                 "<?xml version=\"1.0\"?>\n"
                 "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
                 "header_type=\"UInt64\">\n"
                 "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
                 mesh.nodes.size(), mesh.tetrahedra.size());
  write_point_data(out, mesh, fields);
  write_cell_data(out, mesh, fields);
  fmt::format_to(out, "<Points>\n");
  write_array(out, "Float64", "Points", 3, [&] {
    for (const Vec3& x : mesh.nodes) fmt::format_to(out, "{} {} {}\n", x.x(), x.y(), x.z());
  });
  fmt::format_to(out, "</Points>\n");
  write_cells(out, mesh);
  fmt::format_to(out, "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
  return fmt::to_string(text);
}

void write_vtu(const std::filesystem::path& file, const TetMesh& mesh, const VtuFields& fields) {
  base::write_atomically(file, vtu_text(mesh, fields));
}

}  // namespace palpate::sim
