#include "sim/mesh/convert_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>

#include "sim/mesh/read_mesh.hpp"
#include "sim/mesh/volume.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::sim {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Sets a variable of the environment for a while.
class Set {
 public:
  Set(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    ::setenv(name, value.c_str(), 1);
  }
  ~Set() { before_ ? ::setenv(name_, before_->c_str(), 1) : ::unsetenv(name_); }
  Set(const Set&) = delete;
  Set& operator=(const Set&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_{};
};

// A cube of six tetrahedra, each format written here by its own description.
constexpr const char* kMsh1 =
    "$NOD\n8\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n$ENDNOD\n$ELM\n6\n"
    "1 4 1 1 4 1 2 3 7\n2 4 1 1 4 1 3 4 7\n3 4 1 1 4 1 4 8 7\n4 4 1 1 4 1 8 5 7\n5 4 1 1 4 1 5 6 7\n"
    "6 4 1 1 4 1 6 2 7\n$ENDELM\n";
constexpr const char* kVtk =
    "# vtk DataFile Version 2.0\ncube\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n\nCELLS 6 30\n"
    "4 0 1 2 6\n4 0 2 3 6\n4 0 3 7 6\n4 0 7 4 6\n4 0 4 5 6\n4 0 5 1 6\n\nCELL_TYPES 6\n10\n10\n10\n10\n10\n10\n";
constexpr const char* kNastran =
    "GRID,1,0,0.,0.,0.\nGRID,2,0,1.,0.,0.\nGRID,3,0,1.,1.,0.\nGRID,4,0,0.,1.,0.\nGRID,5,0,0.,0.,1.\n"
    "GRID,6,0,1.,0.,1.\nGRID,7,0,1.,1.,1.\nGRID,8,0,0.,1.,1.\nCTETRA,1,1,1,2,3,7\nCTETRA,2,1,1,3,4,7\n"
    "CTETRA,3,1,1,4,8,7\nCTETRA,4,1,1,8,5,7\nCTETRA,5,1,1,5,6,7\nCTETRA,6,1,1,6,2,7\nENDDATA\n";

class ConvertMesh : public testing::Test {
 protected:
  fs::path write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
    return folder_.path() / name;
  }
  static std::string refusal(const fs::path& file) {
    try {
      read_mesh(file, 1.0);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "nothing thrown";
  }

  palpate::test::TemporaryFolder folder_;
  const Set cache_{"PALPATE_CACHE", (folder_.path() / "cache").string()};
};

/// With the Gmsh that packages.txt lists.
class WithGmsh : public ConvertMesh {};

TEST_F(WithGmsh, ReadsWhatOtherSimulatorsKeep) {
  for (const auto& [name, text] : {std::pair{"one.msh", kMsh1}, std::pair{"legacy.vtk", kVtk},
                                   std::pair{"LEGACY.VTK", kVtk}, std::pair{"nastran.bdf", kNastran}}) {
    const MeshFile read = read_mesh(write(name, text), 1e-3);
    EXPECT_EQ(read.mesh.nodes.size(), 8U) << name;
    EXPECT_EQ(read.mesh.tetrahedra.size(), 6U) << name;
    double volume = 0.0;
    for (const Tetrahedron& tetrahedron : read.mesh.tetrahedra)
      volume += signed_volume(read.mesh, tetrahedron);
    EXPECT_NEAR(volume, 1e-9, 1e-20) << name;  // a cube of 1 mm
  }
}

// The second time it comes from the cache: no gmsh is needed, and nothing is said.
TEST_F(WithGmsh, ConvertsOnce) {
  const fs::path file = write("legacy.vtk", kVtk);
  testing::internal::CaptureStderr();
  read_mesh(file, 1.0);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            file.string() + ": is legacy VTK; gmsh has converted it, once: the result is kept\n");
  const Set nowhere("PATH", folder_.path().string());
  testing::internal::CaptureStderr();
  EXPECT_EQ(read_mesh(file, 1.0).mesh.tetrahedra.size(), 6U);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(WithGmsh, SaysWhatGmshCannotRead) {
  EXPECT_THAT(refusal(write("broken.vtk", "# vtk DataFile Version 2.0\nnothing more\n")),
              testing::AnyOf(HasSubstr("gmsh cannot read this file"), HasSubstr("no tetrahedron")));
}

// Gmsh takes what it does not know for a script, and runs options that lie beside a file.
TEST_F(WithGmsh, RunsNoScriptOfAStranger) {
  const fs::path mark = folder_.path() / "mark";
  const std::string script = "SystemCall \"touch " + mark.string() + "\";\n";
  write("legacy.vtk.opt", script);
  read_mesh(write("legacy.vtk", kVtk), 1.0);
  for (const char* name : {"script.inp", "script.vtk", "script.unv", "script.bdf", "script.mesh",
                           "script.dat", "script.nas", "script.med", "script.msh"})
    EXPECT_NE(refusal(write(name, script)), "nothing thrown") << name;
  EXPECT_FALSE(fs::exists(mark));
}

TEST_F(ConvertMesh, WithoutGmshTheCommandIsNamed) {
  const Set nowhere("PATH", folder_.path().string());
  const std::string said = refusal(write("legacy.vtk", kVtk));
  EXPECT_THAT(said, HasSubstr("legacy.vtk: is legacy VTK, which is left to Gmsh, and the program gmsh is not "
                              "installed; accepted: MSH 2.2 or 4.1 and VTU, as `gmsh FILE -save -save_all "
                              "-format msh41 -o OUT.msh` writes"));
}

TEST(FormatOfGmsh, IsToldByContentThenByEnding) {
  EXPECT_EQ(format_of_gmsh("$NOD\n1", "a.txt"), "an old version of MSH");
  for (const char* version : {"1", "2", "2.0", "2.1", "4", "4.0"})
    EXPECT_TRUE(format_of_gmsh(std::string("$MeshFormat\n") + version + " 0 8\n", "a.msh")) << version;
  for (const char* version : {"2.2", "4.1", "3", "5.0"})
    EXPECT_FALSE(format_of_gmsh(std::string("$MeshFormat\n") + version + " 0 8\n", "a.msh")) << version;
  EXPECT_FALSE(format_of_gmsh("$MeshFormat\n4.1 0 8\n", "a.vtk"));  // whatever it is called
  EXPECT_FALSE(format_of_gmsh("<?xml", "a.vtk"));
  EXPECT_FALSE(format_of_gmsh("", "a.vtk"));
  EXPECT_FALSE(format_of_gmsh("solid", "a.stl"));
  EXPECT_EQ(format_of_gmsh("*NODE", "a.INP"), "Abaqus INP");
}

}  // namespace
}  // namespace palpate::sim
