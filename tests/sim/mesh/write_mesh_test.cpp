#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <system_error>

#include "sim/mesh/quality.hpp"
#include "sim/mesh/write_msh.hpp"
#include "sim/mesh/write_vtu.hpp"
#include "tests/sim/mesh/fixtures.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::sim::test {
namespace {

using palpate::test::TemporaryFolder;
using testing::HasSubstr;

TetMesh boxes() {
  TetMesh mesh = read_mesh(data_file("two_boxes.v41.text.msh"), 1e-3).mesh;
  for (Vec3& x : mesh.nodes) x += Vec3(1.0 / 3.0, -2e-17, 1e4);  // digits that a careless writer loses
  return mesh;
}

TEST(WriteMsh, ReadsBackTheSame) {
  const TemporaryFolder folder;
  const TetMesh mesh = boxes();
  write_msh(folder / "out.msh", mesh);
  const MeshFile read = read_mesh(folder / "out.msh", 1.0);
  EXPECT_EQ(read.mesh.nodes, mesh.nodes);
  EXPECT_EQ(read.mesh.node_tags, mesh.node_tags);
  EXPECT_EQ(read.mesh.tetrahedra, mesh.tetrahedra);
  EXPECT_EQ(read.mesh.region, mesh.region);
  EXPECT_EQ(read.mesh.region_names, mesh.region_names);
  EXPECT_EQ(read.mesh.node_groups, mesh.node_groups);
  EXPECT_EQ(read.repairs.reordered_tetrahedra + read.repairs.welded_nodes + read.repairs.unreferenced_nodes,
            0);
}

TEST(WriteMsh, NumbersNodesAfreshWhereMshCannotKeepTheirTags) {
  const TemporaryFolder folder;
  TetMesh cube = cube_mesh(1, 1.0);
  cube.node_tags = {0, 1, 2, 3, 4, 5, 6, 7};  // as read from VTU
  write_msh(folder / "out.msh", cube);
  EXPECT_EQ(read_mesh(folder / "out.msh", 1.0).mesh.node_tags,
            (std::vector<std::int64_t>{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(WriteMsh, RefusesNamesThatMshCannotHold) {
  const TemporaryFolder folder;
  TetMesh cube = cube_mesh(1, 1.0);
  cube.node_groups["the \"soft\" part"] = {0};
  EXPECT_THROW(write_msh(folder / "out.msh", cube), std::invalid_argument);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(WriteVtu, ReadsBackTheSameButRegionsByNumber) {
  const TemporaryFolder folder;
  const TetMesh mesh = boxes();
  write_vtu(folder / "out.vtu", mesh, {});
  const MeshFile read = read_mesh(folder / "out.vtu", 1.0);
  EXPECT_EQ(read.mesh.nodes, mesh.nodes);
  EXPECT_EQ(read.mesh.tetrahedra, mesh.tetrahedra);
  EXPECT_EQ(read.mesh.region, mesh.region);
  EXPECT_EQ(read.mesh.region_names, (std::vector<std::string>{"0", "1"}));
  EXPECT_EQ(read.mesh.node_groups, mesh.node_groups);
}

TEST(WriteVtu, WritesFieldsWithAllDigitsAndEscapesNames) {
  const TemporaryFolder folder;
  const TetMesh cube = cube_mesh(1, 1.0);
  VtuFields fields;
  fields.point_vectors["displacement"] = Eigen::Matrix3Xd::Constant(3, 8, 0.1 + 0.2);
  fields.cell_scalars["a < b & \"c\""] = Eigen::VectorXd::Constant(6, 1e-300);
  write_vtu(folder / "out.vtu", cube, fields);
  const std::string text = read_bytes(folder / "out.vtu");
  EXPECT_THAT(text, HasSubstr("Name=\"displacement\" NumberOfComponents=\"3\""));
  EXPECT_THAT(text, HasSubstr("0.30000000000000004 0.30000000000000004 0.30000000000000004"));
  EXPECT_THAT(text, HasSubstr("Name=\"a &lt; b &amp; &quot;c&quot;\""));
  EXPECT_THAT(text, HasSubstr("\n1e-300\n"));
  EXPECT_EQ(read_mesh(folder / "out.vtu", 1.0).mesh.tetrahedra, cube.tetrahedra);
}

TEST(WriteMesh, LeavesNothingBehindWhereThereIsNoFolder) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_msh(folder / "none" / "out.msh", cube_mesh(1, 1.0)), std::invalid_argument);
  EXPECT_THROW(write_vtu(folder / "none" / "out.vtu", cube_mesh(1, 1.0), {}), std::invalid_argument);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace palpate::sim::test
