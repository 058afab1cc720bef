#include "sim/mesh/convert_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

#include "base/files/atomic_file.hpp"
#include "base/files/file_error.hpp"
#include "base/files/read_file.hpp"
#include "base/files/sha256.hpp"
#include "base/machine/cache_folder.hpp"
#include "base/machine/run_program.hpp"

namespace palpate::sim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kKept = ".converted";
constexpr const char* kCommand = "gmsh FILE -save -save_all -format msh41 -o OUT.msh";

struct ByEnding {
  std::string_view ending, format;
};
constexpr std::array<ByEnding, 9> kByEnding{{{".vtk", "legacy VTK"},
                                             {".unv", "UNV"},
                                             {".med", "MED"},
                                             {".mmed", "MED"},
                                             {".mesh", "Medit"},
                                             {".inp", "Abaqus INP"},
                                             {".bdf", "Nastran"},
                                             {".nas", "Nastran"},
                                             {".dat", "Nastran"}}};

// An Abaqus mesh of one tetrahedron. A Gmsh that does not know the format takes it for a script of its own,
// and no script of a stranger may be run: so it is asked with this one first.
constexpr std::string_view kAbaqusProbe =
    "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n*ELEMENT, type=C3D4, ELSET=Volume1\n"
    "1, 1, 2, 3, 4\n";

std::string lower_case_ending(const fs::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

/// "2.1" of a file that begins with $MeshFormat.
std::string_view msh_version(std::string_view bytes) {
  const auto from = bytes.find_first_of("0123456789");
  return from == std::string_view::npos ? ""
                                        : bytes.substr(from, bytes.find_first_of(" \t\r\n", from) - from);
}

bool is_old_msh(std::string_view bytes) {
  if (bytes.starts_with("$NOD")) return true;  // MSH 1; later ones have $Nodes
  const std::string_view version = bytes.starts_with("$MeshFormat") ? msh_version(bytes) : "";
  return version == "1" || version == "2" || version == "2.0" || version == "2.1" || version == "4" ||
         version == "4.0";
}

/// A folder of its own for gmsh to work in, gone at the end.
class Workshop {
 public:
  Workshop() {
    std::string name = (fs::temp_directory_path() / "palpate-mesh.XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) base::throw_cannot(errno, "make a folder", name);
    folder_ = name;
  }
  ~Workshop() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  /// MSH 4.1 of a mesh under this ending, or nothing when gmsh cannot read it; then words() tells why.
  std::optional<std::string> convert(std::string_view bytes, const std::string& ending) const {
    const fs::path in = folder_ / ("mesh" + ending), out = folder_ / "out.msh";
    base::write_atomically(in, bytes);
    std::error_code ignored;
    fs::remove(out, ignored);
    const auto code = base::run_program(
        {"gmsh", in.string(), "-save", "-save_all", "-format", "msh41", "-o", out.string(), "-v", "1"},
        folder_ / "words");
    if (!code) throw std::invalid_argument("the program gmsh is not installed");
    if (*code != 0 || !fs::exists(out)) return std::nullopt;
    return base::read_file(out);
  }

  /// What gmsh complained of first, in one line.
  std::string words() const {
    std::string said = base::read_file(folder_ / "words");
    said = said.substr(0, said.find('\n'));
    for (const std::string& own : {(folder_ / "").string(), std::string("Error   : ")})
      for (auto at = said.find(own); at != std::string::npos; at = said.find(own)) said.erase(at, own.size());
    return said.empty() ? "it gives no reason" : said;
  }

 private:
  fs::path folder_{};
};

bool reads_abaqus(const Workshop& workshop) {
  const auto probe = workshop.convert(kAbaqusProbe, ".inp");
  return probe && probe->find("$Elements") != std::string::npos;
}

std::string convert(std::string_view bytes, const fs::path& file, const std::string& format) {
  const std::string ending = is_old_msh(bytes) ? ".msh" : lower_case_ending(file);
  const Workshop workshop;
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument(fmt::format(
        "{}: is {}, which is left to Gmsh, and {}; accepted: MSH 2.2 or 4.1 and VTU, as `{}` writes",
        file.string(), format, why, kCommand));
  };
  try {
    if (ending == ".inp" && !reads_abaqus(workshop)) refuse("the gmsh that is installed does not read it");
    const auto converted = workshop.convert(bytes, ending);
    if (!converted) refuse(fmt::format("gmsh cannot read this file ({})", workshop.words()));
    return *converted;
  } catch (const std::invalid_argument& error) {
    if (std::string_view(error.what()).starts_with("the program gmsh")) refuse(error.what());
    throw;
  }
}

}  // namespace

std::optional<std::string> format_of_gmsh(std::string_view bytes, const fs::path& file) {
  if (is_old_msh(bytes)) return "an old version of MSH";
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos || bytes[start] == '<' || bytes.starts_with("$MeshFormat"))
    return std::nullopt;
  const auto found = std::ranges::find(kByEnding, lower_case_ending(file), &ByEnding::ending);
  return found == kByEnding.end() ? std::nullopt : std::optional<std::string>(found->format);
}

std::string converted_by_gmsh(std::string_view bytes, const fs::path& file) {
  const std::string format = format_of_gmsh(bytes, file).value_or("no mesh that is known");
  const fs::path folder = base::cache_folder();
  const fs::path kept = folder / (base::sha256_hex(fmt::format("{}\n{}", format, bytes)) + kKept);
  std::error_code none;
  if (!folder.empty() && fs::exists(kept, none)) {
    fs::last_write_time(kept, fs::file_time_type::clock::now(), none);
    return base::read_file(kept);
  }
  std::string converted = convert(bytes, file, format);
  fmt::print(stderr, "{}: is {}; gmsh has converted it{}\n", file.string(), format,
             folder.empty() ? "" : ", once: the result is kept");
  if (folder.empty()) return converted;
  try {
    fs::create_directories(folder);
    base::write_atomically(kept, converted);
  } catch (const std::system_error&) {  // a cache costs time, never the run
  }
  return converted;
}

}  // namespace palpate::sim
