#include "tests/sim/support/graded_block.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "sim/mesh/read_mesh.hpp"

namespace palpate::sim::test {
namespace {

constexpr const char* kGeometry = R"geo(SetFactory("OpenCASCADE");
Box(1) = {{-{half}, -{half}, -{half}, {width}, {width}, {half}}};
Point(100) = {{0, 0, 0, 1}};
Point{{100}} In Surface {{6}};
Physical Volume("body") = {{1}};
Field[1] = MathEval;
Field[1].F = "{h} + {growth} * max(0, sqrt(x*x + y*y + z*z) - {fine})";
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.MshFileVersion = 4.1;
)geo";

}  // namespace

TetMesh graded_block(const std::filesystem::path& folder, const GradedBlock& block) {
  const auto geometry = folder / "graded.geo", mesh = folder / "graded.msh";
  std::ofstream(geometry) << fmt::format(kGeometry, fmt::arg("half", block.half),
                                         fmt::arg("width", 2 * block.half), fmt::arg("h", block.h),
                                         fmt::arg("growth", block.growth), fmt::arg("fine", block.fine));
  const std::string made = fmt::format("gmsh {} -3 -nt 1 -v 1 -o {}", geometry.string(), mesh.string());
  if (std::system(made.c_str()) != 0) throw std::runtime_error("no mesh by: " + made);
  return read_mesh(mesh, 1.0).mesh;
}

}  // namespace palpate::sim::test
