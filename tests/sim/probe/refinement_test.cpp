// What has a limit as meshes become finer, and what has none.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

#include "sim/cycle/press.hpp"
#include "sim/mesh/write_msh.hpp"
#include "tests/sim/support/body_table.hpp"
#include "tests/sim/support/box_mesh.hpp"
#include "tests/sim/support/graded_block.hpp"
#include "tests/sim/support/two_boxes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::sim {
namespace {

/// Force against the finger at a depth, on a block that is held at its group "held" and has one "top" [N].
double felt(const TetMesh& mesh, const std::string& body, const std::string& probe, double depth) {
  const palpate::test::TemporaryFolder folder;
  write_msh(folder / "block.msh", mesh);
  std::ofstream(folder / "scene.toml")
      << "name = \"block\"\n"
      << test::body_table("block", "held", "top") << body << "[probes.finger]\nbody = \"block\"\n"
      << probe << "direction = [0, 0, -1]\ndepth = \"1 mm\"\n";
  const Model model = test::compile_scene(folder / "scene.toml");
  return normal_force(model.probes[0], press(model, depth, 1).curve[0].probe_forces[0]);
}

constexpr double kPadRadius = 3e-3, kPadDepth = 0.1e-3;  // [m]

/// A force on a half-space with the weights of a pad, w(r) ~ 1 - r^2/R^2, moves the mean under the same weights by
/// F (1 - nu^2) / (pi E R) times the integral of (8 J2(x) / x^2)^2: their Hankel transform against that of Boussinesq's
/// solution. Source: [Johnson1985] section 3.2 for the latter.
double force_of_half_space() {
  const auto squared = [](double x) {
    const double transform = x < 1e-3 ? 1.0 : 8.0 * boost::math::cyl_bessel_j(2, x) / (x * x);
    return transform * transform;
  };
  double integral = 0.0;
  for (int i = 0; i < 100; ++i)
    integral +=
        boost::math::quadrature::gauss_kronrod<double, 15>::integrate(squared, 2.0 * i, 2.0 * i + 2.0);
  return kPadDepth * std::numbers::pi * 1e6 * kPadRadius / ((1 - 0.4 * 0.4) * integral);
}

double force_of_pad(double h) {
  const palpate::test::TemporaryFolder folder;
  TetMesh mesh = test::graded_block(
      folder.path(),
      {.half = 0.12, .h = h, .fine = 1.2 * kPadRadius, .growth = 0.5 * std::sqrt(h / kPadRadius)});
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const Vec3& node = mesh.nodes[i];
    if (node.z() < -0.12 + 1e-9) mesh.node_groups["held"].push_back(static_cast<int>(i));
    if (node.z() > -1e-9 && node.norm() < kPadRadius) mesh.node_groups["top"].push_back(static_cast<int>(i));
  }
  return felt(mesh, "", "kind = \"pad\"\nradius = \"3 mm\"\nat = [\"0 mm\", \"0 mm\", \"0 mm\"]\n",
              kPadDepth);
}

// The block is 80 pad radii wide. Linear tetrahedra are too stiff, the less the finer they are.
TEST(Refinement, APadsStiffnessConvergesToThatOnAHalfSpace) {
  double before = std::numeric_limits<double>::infinity();
  for (const double cells : {2.0, 4.0, 7.0}) {
    const double error = std::abs(force_of_pad(kPadRadius / cells) / force_of_half_space() - 1.0);
    EXPECT_LT(error, before) << cells;
    before = error;
  }
  EXPECT_LT(before, 0.08);
}

/// A block of n x n cells from above, with a nodule: a cube of 10 mm whose top is 5 mm below the middle of the block's.
TetMesh block(int n) {
  TetMesh mesh = test::box_mesh(n, n, 2 * n / 3, Vec3(30e-3, 30e-3, 20e-3));
  mesh.node_groups["held"] = mesh.node_groups["z_min"];
  mesh.node_groups["top"] = mesh.node_groups["z_max"];
  mesh.region_names = {"nodule"};
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    Vec3 middle = Vec3::Zero();
    for (const int node : mesh.tetrahedra[t]) middle += mesh.nodes[node] / 4;
    if ((middle - Vec3(15e-3, 15e-3, 10e-3)).lpNorm<Eigen::Infinity>() < 5e-3) mesh.region[t] = 0;
  }
  return mesh;
}

double felt_on_block(int n, const std::string& kind, const std::string& body = "") {
  return felt(block(n), body, kind + "at = [\"15 mm\", \"15 mm\", \"20 mm\"]\n", 1e-3);
}

// A force at a point moves the place of a continuum without end: a mesh of half the edges is softer by nearly half, and
// none is the last.
TEST(Refinement, APointsStiffnessDoesNot) {
  const double coarse = felt_on_block(6, "kind = \"point\"\n"),
               fine = felt_on_block(12, "kind = \"point\"\n");
  EXPECT_LT(fine, 0.65 * coarse);
}

// What a nodule of 20 times the stiffness adds to what a pad feels: on a mesh of 12 cells, as on one of 24 to some per
// cent of it (the fields at its edges are singular).
TEST(Refinement, ANodulesShareIsThatOfARefinedMesh) {
  const std::string nodule = "regions.nodule.young_modulus = \"20 MPa\"\n",
                    pad = "kind = \"pad\"\nradius = \"10 mm\"\n";
  const auto share = [&](int n) { return felt_on_block(n, pad, nodule) / felt_on_block(n, pad); };
  const double coarse = share(12), fine = share(24);
  EXPECT_GT(fine, 1.3);
  EXPECT_NEAR(coarse / fine, 1.0, 0.05);
}

}  // namespace
}  // namespace palpate::sim
