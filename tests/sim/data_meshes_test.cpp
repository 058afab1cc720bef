#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include "sim/mesh/quality.hpp"
#include "sim/mesh/read_mesh.hpp"
#include "sim/mesh/surface.hpp"
#include "sim/scene/scene.hpp"
#include "tests/support/places.hpp"

// The meshes and scenes under data/: what the paper's Table 1 asks of them, and what every scene relies on.

namespace palpate::sim {
namespace {

namespace fs = std::filesystem;

const fs::path kData = fs::path(palpate::test::source_folder()) / "data";

std::vector<fs::path> files(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == extension) found.push_back(entry.path());
  std::ranges::sort(found);
  return found;
}

TetMesh mesh_of(const std::string& name) {
  return read_mesh(kData / "meshes" / (name + ".msh"), 1.0).mesh;
}

std::vector<int> without(const std::vector<int>& nodes, const std::vector<int>& left_out) {
  std::vector<int> kept;
  std::ranges::set_difference(nodes, left_out, std::back_inserter(kept));
  return kept;
}

int free_surface_nodes(const TetMesh& mesh) {
  return static_cast<int>(without(extract_surface(mesh).nodes, mesh.node_groups.at("fixed")).size());
}

double distance(const TetMesh& mesh, const Vec3& place) {
  double nearest = INFINITY;
  for (const Vec3& node : mesh.nodes) nearest = std::min(nearest, (node - place).norm());
  return nearest;
}

// [Kuroda2003] Table 1: rectum 282 nodes (207 on the free surface), 889 tetrahedra. A tube whose nodes all
// lie on its surface has 282 + (inner edges) tetrahedra; well shaped ones fall short of 889 (data/README.md),
// so the number is held to 11 % here.
TEST(DataMeshes, RectumHasTheNodesOfTable1) {
  const TetMesh mesh = mesh_of("rectum");
  EXPECT_EQ(mesh.nodes.size(), 282u);
  EXPECT_EQ(free_surface_nodes(mesh), 207);
  EXPECT_NEAR(static_cast<double>(mesh.tetrahedra.size()) / 889.0, 1.0, 0.11);
}

// Table 1: prostate 360 nodes (110 on the free surface), 1312 tetrahedra; aim for the latter: 5 %.
TEST(DataMeshes, ProstateHasTheNodesOfTable1) {
  const TetMesh mesh = mesh_of("prostate");
  EXPECT_EQ(mesh.nodes.size(), 360u);
  EXPECT_EQ(free_surface_nodes(mesh), 110);
  EXPECT_NEAR(static_cast<double>(mesh.tetrahedra.size()) / 1312.0, 1.0, 0.05);
}

TEST(DataMeshes, FinePairHasAboutFourTimesTheNodes) {
  EXPECT_NEAR(static_cast<double>(mesh_of("rectum-fine").nodes.size()) / 282.0, 4.0, 0.4);
  EXPECT_NEAR(static_cast<double>(mesh_of("prostate-fine").nodes.size()) / 360.0, 4.0, 0.4);
}

// Anatomical size, from the parameters of the geometries: outer radius 16 mm, length 60 mm; 40 x 35 x 25 mm,
// of which the faceted surface misses at most the sagitta of one edge, h^2 / 8R < 1 mm.
TEST(DataMeshes, OrgansHaveTheSizeOfTheirGeometries) {
  for (const char* name : {"rectum", "rectum-fine"}) {
    const MeshQuality quality = measure_quality(mesh_of(name));
    EXPECT_TRUE((quality.upper - quality.lower).isApprox(Vec3(0.032, 0.060, 0.032), 0.02)) << name;
  }
  for (const char* name : {"prostate", "prostate-fine"}) {
    const MeshQuality quality = measure_quality(mesh_of(name));
    EXPECT_TRUE((quality.upper - quality.lower).isApprox(Vec3(0.040, 0.035, 0.025), 0.02)) << name;
  }
}

class EveryMesh : public testing::TestWithParam<fs::path> {};

TEST_P(EveryMesh, IsSoundAndNeedsNoMending) {
  const MeshFile file = read_mesh(GetParam(), 1.0);
  EXPECT_EQ(file.repairs.reordered_tetrahedra, 0);
  EXPECT_EQ(file.repairs.welded_nodes, 0);
  EXPECT_EQ(file.repairs.unreferenced_nodes, 0);
  EXPECT_NO_THROW(validate(file.mesh));
  const MeshQuality quality = measure_quality(file.mesh);
  EXPECT_EQ(quality.components, 1);
  EXPECT_GT(quality.min_dihedral, 10.0);
  EXPECT_GT(quality.min_radius_ratio, 0.25);
  EXPECT_GT(quality.mean_radius_ratio, 0.6);  // bricks in order, each cut into six, have 0.6
  EXPECT_THAT(quality.warnings, testing::IsEmpty());
}

TEST_P(EveryMesh, HasItsGroupsAndTheyDoNotMeet) {
  const TetMesh mesh = read_mesh(GetParam(), 1.0).mesh;
  const std::string stem = GetParam().stem().string();
  EXPECT_THAT(mesh.region_names, testing::ElementsAre(stem.substr(0, stem.find('-'))));
  EXPECT_THAT(mesh.region, testing::Each(0));
  for (const auto& [name, nodes] : mesh.node_groups) EXPECT_FALSE(nodes.empty()) << name;
  if (mesh.node_groups.contains("cap"))
    return;  // a hand holds it, and its scene says by a box what may touch
  ASSERT_TRUE(mesh.node_groups.contains("fixed"));
  ASSERT_TRUE(mesh.node_groups.contains("contact"));
  const auto& fixed = mesh.node_groups.at("fixed");
  const auto& contact = mesh.node_groups.at("contact");
  EXPECT_EQ(without(contact, fixed), contact);
  EXPECT_THAT(without(contact, extract_surface(mesh).nodes), testing::IsEmpty());
  EXPECT_THAT(without(fixed, extract_surface(mesh).nodes), testing::IsEmpty());
}

std::string name_of(const testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.stem().string();
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Data, EveryMesh, testing::ValuesIn(files(kData / "meshes", ".msh")), name_of);

class EveryScene : public testing::TestWithParam<fs::path> {};

// The probe asks for a place; a node lies there to a micrometre, so that it presses where the scene says.
TEST_P(EveryScene, HasANodeWhereItsProbePresses) {
  const Scene scene = load_scene(GetParam());
  for (const ProbeSpec& probe : scene.probes) {
    if (!probe.group.empty()) continue;  // it holds a group
    const auto body = std::ranges::find(scene.bodies, probe.body, &BodySpec::name);
    ASSERT_NE(body, scene.bodies.end());
    const TetMesh mesh = read_mesh(body->mesh, body->metres_per_unit).mesh;
    EXPECT_LT(distance(mesh, std::get<Vec3>(probe.at)), 1e-6) << probe.name;
  }
}

TEST_P(EveryScene, LeavesASmallGapAtRest) {
  const Scene scene = load_scene(GetParam());
  ASSERT_EQ(scene.bodies.size(), 2u);
  const auto box = [&](int i) {
    const BodySpec& body = scene.bodies[i];
    MeshQuality quality = measure_quality(read_mesh(body.mesh, body.metres_per_unit).mesh);
    quality.lower += body.offset;
    quality.upper += body.offset;
    return quality;
  };
  // A horizontal plane lies between the two bodies of every scene here, so that they cannot overlap.
  const double gap = std::max(box(0).lower.z() - box(1).upper.z(), box(1).lower.z() - box(0).upper.z());
  EXPECT_GT(gap, 0.05e-3);
  EXPECT_LT(gap, 0.5e-3);
}

INSTANTIATE_TEST_SUITE_P(Data, EveryScene, testing::ValuesIn(files(kData / "scenes", ".toml")), name_of);

}  // namespace
}  // namespace palpate::sim
