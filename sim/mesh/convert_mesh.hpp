#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace palpate::sim {

/// The format of a mesh that this program leaves to Gmsh, in words ("legacy VTK"), told by its content or its
/// name's ending: MSH 1, MSH 2.0 and 2.1, MSH 4.0, legacy VTK, UNV, MED, Medit, Abaqus INP, Nastran. Nothing
/// for any other file.
std::optional<std::string> format_of_gmsh(std::string_view bytes, const std::filesystem::path& file);

/// The mesh as MSH 4.1, converted by the program gmsh, all of its elements with the names of their groups.
/// Kept in the cache under the SHA-256 of the bytes; what is converted is told in a line on stderr. Gmsh gets
/// the bytes alone, in an empty folder and under an ending that it takes for a mesh: no script, no options
/// that lie beside the file. Throws std::invalid_argument when there is no gmsh, with the command to run
/// elsewhere, and when it cannot read the file, with its words; std::system_error when the disk refuses.
std::string converted_by_gmsh(std::string_view bytes, const std::filesystem::path& file);

}  // namespace palpate::sim
