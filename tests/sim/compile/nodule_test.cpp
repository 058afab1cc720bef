// A block with a nodule of another material under the finger.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <fstream>
#include <vector>

#include "sim/cycle/press.hpp"
#include "sim/elasticity/static_solve.hpp"
#include "sim/mesh/write_msh.hpp"
#include "tests/sim/support/body_table.hpp"
#include "tests/sim/support/box_mesh.hpp"
#include "tests/sim/support/two_boxes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::sim {
namespace {

constexpr double kBlockSide = 30e-3, kBlockHeight = 20e-3, kBlockDepth = 2e-3;  // [m]
constexpr double kBlockModulus = 1e6, kPoisson = 0.4;

/// The nodule is what lies within 8 mm of a point 8 mm below the middle of the top.
TetMesh block_with_nodule() {
  TetMesh mesh = test::box_mesh(6, 6, 5, Vec3(kBlockSide, kBlockSide, kBlockHeight));
  const Vec3 centre(kBlockSide / 2, kBlockSide / 2, kBlockHeight - 8e-3);
  mesh.region_names = {"nodule"};
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    Vec3 middle = Vec3::Zero();
    for (const int node : mesh.tetrahedra[t]) middle += mesh.nodes[node] / 4;
    if ((middle - centre).norm() < 8e-3) mesh.region[t] = 0;
  }
  return mesh;
}

/// Force [N] on the finger that presses the middle of the top straight in. @param nodule  lines of the scene file
Vec3 felt(const std::string& nodule) {
  const palpate::test::TemporaryFolder folder;
  write_msh(folder / "block.msh", block_with_nodule());
  std::ofstream(folder / "scene.toml")
      << "name = \"nodule\"\n"
      << test::body_table("block", "z_min", "z_max") << nodule
      << "[probes.finger]\nbody = \"block\"\nkind = \"point\"\nat = [\"15 mm\", \"15 mm\", \"20 mm\"]\n"
         "direction = [0, 0, -1]\ndepth = \"2 mm\"\n";
  return press(test::compile_scene(folder / "scene.toml"), kBlockDepth, 1).curve[0].probe_forces[0];
}

Vec3 felt_of(double modulus, double poisson) {
  return felt(fmt::format("regions.nodule.young_modulus = \"{} Pa\"\nregions.nodule.poisson_ratio = {}\n",
                          modulus, poisson));
}

/// The same by the uncondensed stiffness: three unit forces at the finger's node give its compliance.
Vec3 felt_by_stiffness(double modulus, double poisson) {
  const TetMesh mesh = block_with_nodule();
  const std::vector<Material> materials{{kBlockModulus, kPoisson}, {modulus, poisson}};
  const Eigen::SparseMatrix<double> K = stiffness(mesh, materials);
  const int finger = 3 + 7 * 3 + 7 * 7 * 5;  // (3, 3, 5) of 7 x 7 x 6 nodes
  Eigen::Matrix3d compliance;
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(mesh.nodes.size()));
    forces(axis, finger) = 1.0;
    compliance.col(axis) = static_solve(K, mesh.node_groups.at("z_min"), forces).col(finger);
  }
  return -compliance.inverse() * Vec3(0, 0, -kBlockDepth);
}

TEST(Nodule, IsFeltAsTheUncondensedBlockHasIt) {
  for (const double modulus : {1e4, 1e6, 20e6, 1e9})
    for (const double poisson : {0.1, 0.4, 0.45}) {
      const Vec3 there = felt_by_stiffness(modulus, poisson);
      // Condensed and whole are factorised by other roundings, which the ratio of moduli (to 1000) magnifies.
      EXPECT_LE((felt_of(modulus, poisson) - there).norm(), 1e-9 * there.norm()) << modulus << " " << poisson;
    }
}

TEST(Nodule, TheStifferResistsTheMore) {
  double softer = felt_of(1e3, kPoisson).z();
  for (const double modulus : {1e4, 1e5, 0.99e6, 1e6, 1.01e6, 5e6, 20e6, 1e9}) {
    const double here = felt_of(modulus, kPoisson).z();
    EXPECT_GT(here, softer) << modulus;
    softer = here;
  }
}

// Between the blocks that are all of one or all of the other: energy is no less in a body that is stiffer anywhere.
TEST(Nodule, OfTheBlocksMaterialIsNoneAndElseItIsBetweenTheBlocksOfEitherMaterial) {
  const double without = felt("").z();
  EXPECT_NEAR(felt_of(kBlockModulus, kPoisson).z() / without, 1.0, 1e-12);
  const double with = felt_of(20e6, kPoisson).z();
  EXPECT_GT(with, 1.02 * without);
  EXPECT_LT(with, 20 * without);
}

}  // namespace
}  // namespace palpate::sim
