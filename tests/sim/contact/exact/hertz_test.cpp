// Two elastic bodies with curved faces against Hertz's solution: the law's system and solve, on bodies that are
// brought together by a rigid approach.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <vector>

#include "sim/contact/exact/exact.hpp"
#include "sim/mesh/write_msh.hpp"
#include "tests/sim/support/body_table.hpp"
#include "tests/sim/support/graded_block.hpp"
#include "tests/sim/support/two_boxes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::sim {
namespace {

constexpr double kRadius = 20e-3, kApproach = 0.2e-3;  // [m]
constexpr double kContactRadius = 2e-3;                // sqrt(R d) [m]
constexpr double kHalf = 160e-3;                       // half the width, and the height, of either body [m]
constexpr double kHighest = 0.1 * kHalf;               // that the curved face goes away, far out [m]
constexpr double kModulus = 1e6, kPoisson = 0.4;       // [Pa], [-]

/// Edges h within 1.5 contact radii, growing the less the finer they are.
TetMesh graded_block(const std::filesystem::path& folder, double h) {
  return test::graded_block(
      folder,
      {.half = kHalf, .h = h, .fine = 1.5 * kContactRadius, .growth = 0.5 * std::sqrt(h / kContactRadius)});
}

/// The block with what the scene holds and what may touch; the upper one is turned over, with a face that curves
/// away as a sphere does.
TetMesh body(TetMesh block, bool upper) {
  for (std::size_t i = 0; i < block.nodes.size(); ++i) {
    Vec3& node = block.nodes[i];
    const double r = std::hypot(node.x(), node.y());
    if (std::abs(node.z()) < 1e-9 && r < 1.5 * kContactRadius)
      block.node_groups["near"].push_back(static_cast<int>(i));
    if (std::abs(node.z() + kHalf) < 1e-9) block.node_groups["far"].push_back(static_cast<int>(i));
    if (!upper) continue;
    const double bulge = kHighest * -std::expm1(-r * r / (2 * kRadius * kHighest));
    node = {node.x(), -node.y(), -node.z() + bulge * (1 + node.z() / kHalf)};
  }
  return block;
}

constexpr const char* kProbe = R"([probes.unused]
body = "lower"
kind = "point"
at = ["160 mm", "0 mm", "-40 mm"]
direction = [-1, 0, 0]
depth = "1 mm"
)";

/// Force between the bodies when their supports have come nearer by the approach [N].
double force_of_approach(double h) {
  const palpate::test::TemporaryFolder folder;
  const TetMesh block = graded_block(folder.path(), h);
  write_msh(folder.path() / "upper.msh", body(block, true));
  write_msh(folder.path() / "lower.msh", body(block, false));
  std::ofstream(folder.path() / "scene.toml")
      << test::two_body_tables(test::body_table("upper", "far", "near"),
                               test::body_table("lower", "far", "near"), "exact")
      << kProbe;
  const Model model = test::compile_scene(folder.path() / "scene.toml");
  ExactScratch scratch(model);
  for (std::size_t i = 0; i < scratch.gaps.size(); ++i)
    scratch.gaps[i] -= kApproach * scratch.pairs[i].normal.z() * (scratch.pairs[i].node_body == 0 ? 1 : -1);
  const auto report = scratch.solve.solve(scratch.holds, scratch.values, scratch.gaps);
  EXPECT_LE(report.residual, 1e-10);
  double force = 0.0;
  for (std::size_t i = 0; i < scratch.pairs.size(); ++i)
    force += scratch.solve.forces()[scratch.system.bilateral + static_cast<Eigen::Index>(i)] *
             std::abs(scratch.pairs[i].normal.z());
  return force;
}

// F = 4/3 E* sqrt(R) d^(3/2), 1/E* = 2 (1 - nu^2)/E. Source: [Johnson1985] section 4.2. The bodies are 80 contact
// radii large and no half-spaces, and the face is a paraboloid; the rest of the error falls with the mesh.
TEST(Exact, ConvergesToHertz) {
  const double modulus = kModulus / (2 * (1 - kPoisson * kPoisson));
  const double hertz = 4.0 / 3.0 * modulus * std::sqrt(kRadius) * std::pow(kApproach, 1.5);
  double before = std::numeric_limits<double>::infinity();
  for (const double cells : {2.0, 4.0, 7.0}) {
    const double error = force_of_approach(kContactRadius / cells) / hertz - 1.0;
    EXPECT_LT(std::abs(error), before) << cells;
    before = std::abs(error);
  }
  EXPECT_LT(before, 0.05);
}

}  // namespace
}  // namespace palpate::sim
