#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/mesh/read_mesh.hpp"
#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim::test {

std::filesystem::path data_file(const std::string& name);
std::string read_bytes(const std::filesystem::path& file);

/// All committed MSH and VTU files of the two boxes, in every encoding.
std::vector<std::string> two_boxes_files();

/// n x n x n small cubes of six tetrahedra each in a cube of the given side at the origin (Kuhn's division,
/// which makes neighbours meet).
TetMesh cube_mesh(int n, double side);

/// A mesh as MSH 2.2 text without groups; one line a node from line 6 on, so that tests can name lines.
std::string to_msh2(const TetMesh& mesh);

/// What() of the std::invalid_argument that reading these bytes throws; "" when it throws none.
std::string refusal(std::string_view bytes, const std::string& name = "body.msh");

/// Replaces the first occurrence; the test stops when there is none.
std::string replaced(std::string text, const std::string& from, const std::string& to);

/// Volume by the divergence theorem from the surface alone: sum of a . (b x c) / 6 over outward triangles.
double enclosed_volume(const TetMesh& mesh);

}  // namespace palpate::sim::test
