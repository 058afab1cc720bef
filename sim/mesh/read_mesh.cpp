#include "sim/mesh/read_mesh.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <system_error>

#include "sim/mesh/cursor.hpp"
#include "sim/mesh/parse_mesh.hpp"

namespace palpate::sim {
namespace {

constexpr const char* kAccepted = "Gmsh MSH 2.2 or 4.1 (text or binary) and VTU are accepted";

std::string read_whole(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    throw std::invalid_argument(
        fmt::format("{}: {}; a mesh file is accepted", file.string(),
                    std::filesystem::exists(file) ? "is not a file" : "there is no such file"));
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"), &std::fclose);
  if (!stream) throw std::invalid_argument(fmt::format("{}: cannot be opened for reading", file.string()));
  std::string bytes(std::filesystem::file_size(file), '\0');
  const std::size_t got = std::fread(bytes.data(), 1, bytes.size(), stream.get());
  if (std::ferror(stream.get()) != 0)
    throw std::system_error(errno, std::generic_category(), fmt::format("{}: cannot read", file.string()));
  bytes.resize(got);
  return bytes;
}

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
  if (bytes.starts_with("$MeshFormat")) return mend(parse_msh(bytes, name), name, metres_per_unit);
  if (looks_like_xml(bytes)) return mend(parse_vtu(bytes, name), name, metres_per_unit);
  throw std::invalid_argument(fmt::format("{}:1: found '{}' at the start; {}", name,
                                          printable(bytes.substr(0, bytes.find('\n'))), kAccepted));
}

MeshFile read_mesh(const std::filesystem::path& file, double metres_per_unit) {
  return parse_mesh(read_whole(file), file.string(), metres_per_unit);
}

}  // namespace palpate::sim
