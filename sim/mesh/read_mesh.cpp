#include "sim/mesh/read_mesh.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "base/files/read_file.hpp"
#include "sim/mesh/convert_mesh.hpp"
#include "sim/mesh/cursor.hpp"
#include "sim/mesh/parse_mesh.hpp"

namespace palpate::sim {
namespace {

constexpr const char* kAccepted =
    "Gmsh MSH 2.2 or 4.1 (text or binary) and VTU are accepted, and with Gmsh installed MSH 1, "
    "legacy VTK, UNV, MED, Medit, Abaqus INP and Nastran, by the file name's ending";

bool looks_like_xml(std::string_view bytes) {
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  return start != std::string_view::npos && bytes[start] == '<';
}

}  // namespace

MeshFile parse_mesh(std::string_view bytes, const std::string& name, double metres_per_unit) {
  if (!std::isfinite(metres_per_unit) || metres_per_unit <= 0)
    throw std::invalid_argument(fmt::format(
        "{}: found {} m as the length unit; a positive number is accepted", name, metres_per_unit));
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);  // the byte order mark of UTF-8 editors
  if (bytes.find_first_not_of(" \t\r\n") == std::string_view::npos)
    throw std::invalid_argument(fmt::format("{}: the file is empty; {}", name, kAccepted));
  if (bytes.starts_with('$') && bytes.find("$MeshFormat") != std::string_view::npos)
    return mend(parse_msh(bytes, name), name, metres_per_unit);
  if (looks_like_xml(bytes)) return mend(parse_vtu(bytes, name), name, metres_per_unit);
  throw std::invalid_argument(fmt::format("{}:1: found '{}' at the start; {}", name,
                                          printable(bytes.substr(0, bytes.find('\n'))), kAccepted));
}

MeshFile read_mesh(const std::filesystem::path& file, double metres_per_unit) {
  std::string bytes = base::read_file(file, "a mesh file");
  if (format_of_gmsh(bytes, file)) bytes = converted_by_gmsh(bytes, file);
  return parse_mesh(bytes, file.string(), metres_per_unit);
}

}  // namespace palpate::sim
